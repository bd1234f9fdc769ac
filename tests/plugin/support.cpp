#include "support.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

#include <catch2/catch.hpp>
#include <dlfcn.h>

#include "wheels.h"

namespace elsie::plugin::test {

namespace fs = std::filesystem;

fs::path fixture(const std::string& name) {
  return fs::path(ELSIE_PLUGIN_FIXTURES) / (name + ".so");
}

std::vector<std::byte> bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

void write(const fs::path& file, std::span<const std::byte> bytes) {
  write(file, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

void write(const fs::path& file, std::string_view text) {
  std::ofstream(file, std::ios::binary) << text;
}

Folder& Folder::with(const std::string& name) { return with(name, name + ".so"); }

Folder& Folder::with(const std::string& name, const std::string& file_name) {
  fs::copy_file(fixture(name), path() / file_name);
  return *this;
}

FileReport report_of(const Host& host, const std::string& file_name) {
  for (const DirectoryReport& directory : host.report().directories) {
    for (const FileReport& file : directory.files) {
      if (file.path.filename() == file_name) {
        return file;
      }
    }
  }
  throw std::runtime_error("the report says nothing of " + file_name);
}

bool is_loaded(const fs::path& file) {
  void* const handle = dlopen(file.c_str(), RTLD_LAZY | RTLD_NOLOAD);
  if (handle) {
    dlclose(handle);
  }
  return handle != nullptr;
}

WheelRates answer(Behavior& behavior) {
  Random random;
  const OwnState self;
  Perception::Data data;
  data.self = &self;
  return elsie::test::rates(behavior.respond(Perception(data, random)).command);
}

}  // namespace elsie::plugin::test

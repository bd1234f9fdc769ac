#include "elsie/plugin/engine_libraries.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <system_error>
#include <utility>

#include <dlfcn.h>

#include "elsie/plugin/abi_word.h"
#include "elsie/plugin/error.h"
#include "elsie/plugin/inspection.h"
#include "elsie/plugin/own_library.h"

namespace elsie::plugin {
namespace {

namespace fs = std::filesystem;

fs::path folder() {
  static const fs::path found =
      fs::weakly_canonical(file_of_this_library()).parent_path() / "elsie";
  return found;
}
fs::path engines() { return folder() / "engines"; }

/// A sentence if this program cannot load the file as a library.
std::string fault_of(const fs::path& file) {
  const Inspection found = inspect_file(file);
  return found.kind == FileKind::plugin_library
             ? abi_mismatch(host_abi_word(), found.abi_word).value_or("")
             : found.sentence;
}

}  // namespace

std::vector<std::string> engine_names() {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(engines(), error), end; !error && at != end; at.increment(error)) {
    if (at->path().extension() == ".so") {
      names.push_back(at->path().stem().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

fs::path engine_file(const std::string& name) { return engines() / (name + ".so"); }

fs::path part_file(const std::string& name) { return folder() / (name + ".so"); }

void* engine_symbol(const std::string& name, const char* symbol) {
  return part_symbol("the physics engine '" + name + "'", engine_file(name), symbol);
}

void* part_symbol(const std::string& what, const fs::path& file, const char* symbol) {
  // The system's loader compares the file with every library that is loaded.
  static std::mutex guard;
  static std::map<std::pair<fs::path, std::string>, void*> known;
  const std::lock_guard lock(guard);
  void*& address = known[{file, symbol}];
  if (address) return address;
  const auto refuse = [&](const std::string& why) {
    throw PluginError("the library of " + what + ", " + file.string() + ", " + why +
                          "; reinstall Elsie, or delete the file and build it again",
                      base::kOtherFailure);
  };
  // A loaded library was inspected before.
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NOLOAD);
  if (!library) {
    if (const std::string fault = fault_of(file); !fault.empty()) refuse(fault);
    library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  }
  if (!library) refuse(std::string("cannot be loaded: ") + dlerror());
  void* const found = dlsym(library, symbol);
  if (!found) {
    dlclose(library);
    refuse(std::string("does not export '") + symbol + "'");
  }
  return address = found;
}

}  // namespace elsie::plugin

#include "elsie/files/outputs.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include <unistd.h>

#include "elsie/base/error.h"
#include "elsie/files/write_whole.h"

namespace fs = std::filesystem;

namespace elsie::files {
namespace {

fs::path end_of(const fs::path& file) {
  if (file.empty()) {
    return file;
  }
  std::error_code error;
  // Links may lead to a file that does not exist yet.
  const fs::path end = fs::weakly_canonical(end_of_links(fs::absolute(file)), error);
  return error ? fs::absolute(file).lexically_normal() : end;
}

/// The start of an existing file; empty if there is none.
std::string start_of(const fs::path& file) {
  std::error_code error;
  std::string start;
  if (fs::is_regular_file(file, error)) {
    start.resize(1024);
    std::ifstream in(file, std::ios::binary);
    in.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(in.gcount()));
  }
  return start;
}

}  // namespace

void require_writable(const fs::path& file, const std::string& named_by) {
  const std::string what = named_by + ": cannot write '" + file.string() + "': ";
  std::error_code error;
  if (file.empty() || fs::is_directory(file, error)) {
    throw base::BadInput(what +
                         (file.empty() ? "the name of a file is missing" : "it is a directory"));
  }
  const fs::path end = end_of_links(file);
  const fs::path folder = end.has_parent_path() ? end.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) {
    throw base::BadInput(what + "there is no folder '" + folder.string() + "'; make it first");
  }
  const bool exists = fs::exists(file, error);
  if (error == std::errc::filename_too_long) throw base::BadInput(what + "its name is too long");
  if (access(exists ? file.c_str() : folder.c_str(), W_OK) != 0) {
    throw base::BadInput(what + "permission denied");
  }
}

void require_replaceable(const fs::path& file, const std::string& named_by, const std::string& kind,
                         const std::function<bool(std::string_view start)>& is_kind) {
  require_writable(file, named_by);
  const std::string start = start_of(file);
  if (!start.empty() && !is_kind(start)) {
    throw base::BadInput(named_by + ": '" + file.string() + "' already exists and is not a " +
                         kind + "; remove it or choose another name");
  }
}

void require_stem(const fs::path& file, const std::string& named_by, std::string_view suffix) {
  if (file.filename() == suffix) {
    throw base::BadInput(named_by + ": '" + file.string() +
                         "' lacks a name before its suffix; expected one such as run" +
                         std::string(suffix));
  }
}

bool is_device(const fs::path& file) {
  std::error_code error;
  return fs::is_character_file(file, error) || fs::is_fifo(file, error);
}

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return fs::equivalent(a, b, error) || end_of(a) == end_of(b);
}

void require_apart(const std::vector<Output>& outputs, const std::vector<fs::path>& inputs) {
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    const auto is_it = [&](const fs::path& file) { return is_same_file(file, output->file); };
    if (is_device(output->file)) {
      continue;
    }
    const std::string what = output->named_by + ": '" + output->file.string() + "' ";
    if (const auto input = std::find_if(inputs.begin(), inputs.end(), is_it);
        input != inputs.end()) {
      const bool same_name =
          fs::absolute(*input).lexically_normal() == fs::absolute(output->file).lexically_normal();
      throw base::BadInput(what + "is " +
                           (same_name ? "" : "the file '" + input->string() + "', which is ") +
                           "read here, and its content would be lost; choose another name");
    }
    const auto other = std::find_if(outputs.begin(), output,
                                    [&](const Output& before) { return is_it(before.file); });
    if (other != output) {
      throw base::BadInput(what +
                           (other->named_by == output->named_by
                                ? "is given twice"
                                : "is also the file of " + other->named_by) +
                           "; choose another name");
    }
  }
}

}  // namespace elsie::files

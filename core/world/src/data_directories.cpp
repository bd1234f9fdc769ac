#include "elsie/world/data_directories.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "elsie/plugin/own_library.h"
#include "elsie/world/error.h"
#include "elsie/world/files.h"

namespace elsie::world {
namespace {

namespace fs = std::filesystem;

class Directories {
 public:
  void add(const fs::path& directory) {
    std::error_code ignored;
    fs::path canonical = fs::weakly_canonical(directory, ignored);  // for comparing only
    if (!canonical.has_filename()) {
      canonical = canonical.parent_path();  // it ends with a slash
    }
    if (std::find(canonical_.begin(), canonical_.end(), canonical) == canonical_.end()) {
      canonical_.push_back(std::move(canonical));
      names_.push_back(directory.string());
    }
  }
  std::vector<std::string> names() && { return std::move(names_); }

 private:
  std::vector<fs::path> canonical_;
  std::vector<std::string> names_;
};

fs::path data_below(const fs::path& prefix) { return prefix / "share" / "elsie"; }

/// Of the installation that libelsie is in: its library folder is lib/ or, on Debian,
/// lib/x86_64-linux-gnu/.
fs::path data_of_installation(const fs::path& library) {
  const fs::path prefix = library.parent_path().parent_path();
  std::error_code error;
  return !fs::is_directory(data_below(prefix), error) &&
                 fs::is_directory(data_below(prefix.parent_path()), error)
             ? data_below(prefix.parent_path())
             : data_below(prefix);
}

}  // namespace

std::vector<std::string> default_data_directories() {
  Directories directories;
  if (const char* const variable = std::getenv(kDataPathVariable)) {
    std::string_view rest = variable;
    while (!rest.empty()) {
      const std::string_view directory = rest.substr(0, rest.find(':'));
      rest.remove_prefix(std::min(directory.size() + 1, rest.size()));
      if (!directory.empty()) {
        directories.add(directory);
      }
    }
  }
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path beside = data_below(program.parent_path().parent_path());
  if (fs::is_directory(beside, error)) {
    directories.add(beside);
  }
  const fs::path library = fs::canonical(plugin::file_of_this_library(), error);
  if (!error) {
    directories.add(data_of_installation(library));
  }
  return std::move(directories).names();
}

std::string find_document(const std::string& name,
                          const std::vector<std::string>& data_directories) {
  std::error_code error;
  if (name.empty() || fs::path(name).is_absolute() || data_directories.empty() ||
      fs::exists(fs::symlink_status(name, error))) {
    return name;  // what is wrong with it, its reader says
  }
  const Files files(name, data_directories);
  if (auto found = files.find_data(name)) {
    return std::move(*found);
  }
  std::string near = near_file(name);
  for (const std::string& directory : data_directories) {
    if (near.empty()) {
      near = near_file((fs::path(directory) / name).string());
    }
  }
  if (!near.empty()) {
    near = fs::path(name).replace_filename(fs::path(near).filename()).string();
  }
  throw WorldError(
      {{name, 0,
        "there is no such file; looked in the current folder or " + files.data_places() +
            (near.empty() ? "" : "; did you mean '" + near + "'?")}});
}

}  // namespace elsie::world

#include "elsie/world/data_directories.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "elsie/plugin/own_library.h"
#include "elsie/plugin/search_path.h"
#include "elsie/world/error.h"
#include "elsie/world/files.h"

namespace elsie::world {
namespace {

namespace fs = std::filesystem;

fs::path data_below(const fs::path& prefix) { return prefix / "share" / "elsie"; }

/// The data directory of the installation that contains libelsie. The library folder is lib/ or, on
/// Debian, lib/x86_64-linux-gnu/.
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
  plugin::DirectoryList list;
  list.add_variable(kDataPathVariable);
  list.add_beside_program(data_below({}));
  std::error_code error;
  const fs::path library = fs::canonical(plugin::file_of_this_library(), error);
  if (!error) {
    list.add(data_of_installation(library), "next to libelsie");
  }
  std::vector<std::string> names;
  for (const plugin::SearchDirectory& directory : std::move(list).take()) {
    names.push_back(directory.path.string());
  }
  return names;
}

std::string find_document(const std::string& name,
                          const std::vector<std::string>& data_directories) {
  std::error_code error;
  if (name.empty() || fs::path(name).is_absolute() || data_directories.empty() ||
      fs::exists(fs::symlink_status(name, error))) {
    return name;  // its reader reports what is wrong with it
  }
  const Files files(name, data_directories);
  if (auto found = files.find_data(name)) return std::move(*found);
  std::vector<std::string> folders{""};
  folders.insert(folders.end(), data_directories.begin(), data_directories.end());
  throw WorldError({{name, 0,
                     "there is no such file; looked in the current folder or " +
                         files.data_places() + did_you_mean_file(name, folders)}});
}

}  // namespace elsie::world

#include "elsie/plugin/search_path.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "elsie/plugin/own_library.h"

namespace elsie::plugin {

namespace fs = std::filesystem;

void DirectoryList::add(const fs::path& directory, const std::string& origin) {
  std::error_code ignored;
  // Only for comparison: messages contain the user's text.
  fs::path canonical = fs::weakly_canonical(directory, ignored);
  if (!canonical.has_filename()) {
    canonical = canonical.parent_path();  // it ends with a slash
  }
  if (std::find(canonical_.begin(), canonical_.end(), canonical) == canonical_.end()) {
    canonical_.push_back(canonical);
    directories_.push_back({directory, origin});
  }
}

void DirectoryList::add_variable(const char* name) {
  const char* const value = std::getenv(name);
  std::string_view rest = value ? value : "";
  while (!rest.empty()) {
    const std::string_view directory = rest.substr(0, rest.find(':'));
    rest.remove_prefix(std::min(directory.size() + 1, rest.size()));
    if (!directory.empty()) {
      add(directory, name);
    }
  }
}

void DirectoryList::add_beside_program(const fs::path& below) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path directory = program.parent_path().parent_path() / below;
  if (fs::is_directory(directory, error)) {
    add(directory, "next to the program");
  }
}

std::vector<SearchDirectory> default_search_path(std::span<const fs::path> given) {
  DirectoryList list;
  for (const fs::path& directory : given) {
    list.add(directory, "given");
  }
  list.add_variable(kPluginPathVariable);
  list.add_beside_program("lib/elsie/plugins");
  std::error_code error;
  const fs::path library = fs::canonical(file_of_this_library(), error);
  if (!error) {
    list.add(library.parent_path() / "elsie/plugins", "next to libelsie");
  }
  return std::move(list).take();
}

}  // namespace elsie::plugin

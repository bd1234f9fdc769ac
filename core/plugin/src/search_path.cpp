#include "elsie/plugin/search_path.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <utility>

#include "elsie/plugin/own_library.h"

namespace elsie::plugin {
namespace {

namespace fs = std::filesystem;

class Path {
 public:
  void add(const fs::path& directory, const char* origin) {
    std::error_code ignored;
    // For comparing only; what the user wrote is what the user is told.
    fs::path canonical = fs::weakly_canonical(directory, ignored);
    if (!canonical.has_filename()) {
      canonical = canonical.parent_path();  // it ends with a slash
    }
    if (std::find(canonical_.begin(), canonical_.end(), canonical) == canonical_.end()) {
      canonical_.push_back(canonical);
      directories_.push_back({directory, origin});
    }
  }

  std::vector<SearchDirectory> directories() && { return std::move(directories_); }

 private:
  std::vector<fs::path> canonical_;
  std::vector<SearchDirectory> directories_;
};

}  // namespace

std::vector<SearchDirectory> default_search_path(std::span<const fs::path> given) {
  Path path;
  for (const fs::path& directory : given) {
    path.add(directory, "given");
  }
  if (const char* const variable = std::getenv(kPluginPathVariable)) {
    std::string_view rest = variable;
    while (!rest.empty()) {
      const std::string_view directory = rest.substr(0, rest.find(':'));
      rest.remove_prefix(std::min(directory.size() + 1, rest.size()));
      if (!directory.empty()) {
        path.add(directory, kPluginPathVariable);
      }
    }
  }
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path beside = program.parent_path().parent_path() / "lib/elsie/plugins";
  if (fs::is_directory(beside, error)) {
    path.add(beside, "beside the program");
  }
  const fs::path library = fs::canonical(file_of_this_library(), error);
  if (!error) {
    path.add(library.parent_path() / "elsie/plugins", "beside libelsie");
  }
  return std::move(path).directories();
}

}  // namespace elsie::plugin

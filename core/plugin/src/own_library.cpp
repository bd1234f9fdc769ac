#include "elsie/plugin/own_library.h"

#include <map>
#include <string>

#include <dlfcn.h>
#include <link.h>

namespace elsie::plugin {

namespace fs = std::filesystem;

const void* place_in_this_library() noexcept {
  static const char here = 0;  // no other library has this one
  return &here;
}

fs::path file_of_this_library() {
  Dl_info info{};
  const bool known = dladdr(place_in_this_library(), &info) != 0 && info.dli_fname;
  return known ? fs::path(info.dli_fname) : fs::path();
}

std::vector<fs::path> deciding_libraries() {
  const fs::path own = file_of_this_library();
  // What is loaded counts as it is loaded; what is loaded later lies beside this library.
  std::map<std::string, fs::path> files;  // by the name without its version
  const std::string version = own.filename().string().substr(std::string("libelsie").size());
  for (const char* const name : {"libelsie-inference", "libelsie-views"}) {
    if (const fs::path file = own.parent_path() / (name + version); fs::exists(file)) {
      files[name] = file;
    }
  }
  dl_iterate_phdr(
      [](dl_phdr_info* library, std::size_t, void* found) {
        const fs::path file(library->dlpi_name);
        const std::string name = file.filename().string();
        for (const char* const wanted :
             {"libelsie-base", "libelsie-inference", "libelsie-views", "libode"}) {
          if (name.starts_with(std::string(wanted) + '.')) {
            (*static_cast<std::map<std::string, fs::path>*>(found))[wanted] = file;
          }
        }
        return 0;
      },
      &files);
  std::vector<fs::path> all{own};
  for (const auto& [name, file] : files) {
    all.push_back(file);
  }
  return all;
}

}  // namespace elsie::plugin

#include "elsie/plugin/own_library.h"

#include <algorithm>
#include <string>
#include <string_view>

#include <dlfcn.h>
#include <link.h>

#include "elsie/plugin/search_path.h"

namespace elsie::plugin {

namespace fs = std::filesystem;

fs::path file_of_this_library() {
  Dl_info info{};
  const void* const here = &kPluginPathVariable;
  return dladdr(here, &info) != 0 && info.dli_fname ? fs::path(info.dli_fname) : fs::path();
}

std::vector<fs::path> deciding_libraries() {
  const fs::path own = file_of_this_library();
  std::vector<fs::path> files{own};
  // Inference is loaded with the first plugin that infers: it counts whether one has been or not.
  if (const fs::path inference = own.parent_path() / "libelsie-inference.so";
      fs::exists(inference)) {
    files.push_back(inference);
  }
  dl_iterate_phdr(
      [](dl_phdr_info* library, std::size_t, void* data) {
        const fs::path file(library->dlpi_name);
        const std::string name = file.filename().string();
        if (name.starts_with("libelsie-base.") || name.starts_with("libode.")) {
          static_cast<std::vector<fs::path>*>(data)->push_back(file);
        }
        return 0;
      },
      &files);
  std::sort(files.begin() + 1, files.end(),
            [](const fs::path& a, const fs::path& b) { return a.filename() < b.filename(); });
  return files;
}

}  // namespace elsie::plugin

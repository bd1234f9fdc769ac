#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <link.h>

#include "elsie/batch/plan.h"
#include "elsie/plugin/engine_libraries.h"
#include "elsie/plugin/error.h"
#include "elsie/plugin/own_library.h"

namespace elsie::batch {

namespace fs = std::filesystem;

std::vector<fs::path> deciding_libraries() {
  const fs::path own = plugin::file_of_this_library();
  // A library that is not loaded yet lies beside this one.
  std::map<std::string, fs::path> files;  // by the name without its version
  const std::string version = own.filename().string().substr(std::string("libelsie").size());
  for (const std::string& name : {"libelsie-inference" + version, "libelsie-views" + version,
                                  std::string("libelsie-vision.so")}) {
    if (const fs::path file = own.parent_path() / name; fs::exists(file)) {
      files[name.substr(0, name.find('.'))] = file;
    }
  }
  for (const std::string& engine : plugin::engine_names()) {
    try {
      plugin::engine_symbol(engine, "elsie_make_engine");  // loads what it needs, too
    } catch (const plugin::PluginError&) {
      continue;  // one that cannot be loaded decides no run
    }
    files["engine " + engine] = plugin::engine_file(engine);
  }
  if (fs::exists(plugin::layouts_file())) {
    files["layouts"] = plugin::layouts_file();
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

}  // namespace elsie::batch

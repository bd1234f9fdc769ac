#include "hosts.h"

#include <cstddef>
#include <filesystem>
#include <system_error>
#include <utility>

#include "elsie/base/error.h"
#include "elsie/build/source_build.h"
#include "elsie/plugin/script.h"
#include "elsie/plugin/search_path.h"

#include "bindings.h"

namespace elsie::python {
namespace {

namespace fs = std::filesystem;

plugin::SearchDirectory place_of(const std::string& name) {
  std::error_code error;
  if (fs::is_directory(name, error)) return {name, "plugins="};
  if (!fs::is_regular_file(name, error)) {
    throw base::BadInput("plugins: there is no file or folder '" + name + "'");
  }
  if (build::is_source(name)) {
    return {build::build_source(name).library, "plugins=", name};
  }
  if (!plugin::may_hold_plugins(name)) {
    throw base::BadInput("plugins: '" + name +
                         "' is no plugin library (.so), source (.cpp) or script (.py), and no "
                         "folder of them");
  }
  return {name, "plugins="};
}

}  // namespace

std::shared_ptr<const plugin::Host> default_host() {
  // Scripts run meanwhile, and let other threads of Python run: one that waits here must not keep
  // the GIL from them.
  const py::gil_scoped_release released;
  // Never destroyed: a script's classes must not be released when Python has ended.
  static const auto* const host = new std::shared_ptr<const plugin::Host>(
      std::make_shared<plugin::Host>(plugin::default_search_path()));
  return *host;
}

std::shared_ptr<const plugin::Host> host_with(const std::vector<std::string>& places) {
  if (places.empty()) return default_host();
  std::vector<plugin::SearchDirectory> searched;
  for (const std::string& place : places) searched.push_back(place_of(place));
  for (plugin::SearchDirectory& usual : plugin::default_search_path()) {
    searched.push_back(std::move(usual));
  }
  auto host = std::make_shared<const plugin::Host>(searched);
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::error_code error;
    if (fs::is_directory(places[i], error)) continue;
    for (const plugin::FileReport& file : host->report().directories[i].files) {
      if (file.status != plugin::FileStatus::loaded) {
        throw base::BadInput("plugins: '" + places[i] + "' " + file.sentence);
      }
    }
  }
  return host;
}

}  // namespace elsie::python

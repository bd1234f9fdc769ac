#include <exception>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <link.h>

#include "elsie/api/sensor.h"
#include "elsie/batch/plan.h"
#include "elsie/experiment/plugin_uses.h"
#include "elsie/plugin/engine_libraries.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/own_library.h"
#include "elsie/plugin/parameters.h"
#include "elsie/plugin/script.h"

namespace elsie::batch {
namespace {

namespace fs = std::filesystem;

/// What an engine links to besides libelsie.
constexpr std::pair<const char*, const char*> kOfEngines[] = {{"ode", "libode"}};

/// What plugins in Python depend on: who starts it, the module elsie, the interpreter, numpy.
constexpr const char* kOfPython[] = {"python", "_elsie", "libpython3", "_multiarray_umath"};

bool has_scripts(const world::World& world, const plugin::Host& host) {
  bool has = false;
  experiment::for_each_use(world, [&](PluginKind kind, const world::PluginUse& use) {
    has = has || plugin::is_script(host.file_of(kind, use.plugin));
  });
  return has;
}

bool has_camera(const world::PluginUse& use, const plugin::Host& host) {
  try {
    const auto sensor = host.create<Sensor>(PluginKind::sensor, use.plugin);
    plugin::apply_parameters(*host.find(PluginKind::sensor, use.plugin), *sensor, use.parameters,
                             world::values_of(use.elements));
    return sensor->camera().has_value();
  } catch (const std::exception&) {
    return true;  // it may have one in its robot
  }
}

bool has_cameras(const world::World& world, const plugin::Host& host) {
  std::set<std::pair<std::string, std::map<std::string, ParameterValue>>> known;
  for (const world::Robot& robot : world.robots) {
    for (const world::MountedUse& use : robot.sensors) {
      const bool is_new = known.emplace(use.plugin, use.parameters).second;
      if ((is_new || !use.elements.empty()) && has_camera(use, host)) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<fs::path> deciding_libraries(const world::World& world, const plugin::Host& host) {
  const std::string& engine = world.physics.engine;
  plugin::engine_symbol(engine, "elsie_make_engine");  // loads what it needs, too
  const fs::path own = plugin::file_of_this_library();
  // By the name without its version. A library that is not loaded yet is in the same folder as this
  // one.
  std::map<std::string, fs::path> files{{"engine " + engine, plugin::engine_file(engine)}};
  const std::string version = own.filename().string().substr(std::string("libelsie").size());
  const auto add = [&](const std::string& name, const std::string& suffix) {
    files[name] = own.parent_path() / (name + suffix);
  };
  add("libelsie-base", version);
  add("libelsie-inference", version);
  if (has_cameras(world, host)) {
    add("libelsie-render", version);
    add("libelsie-vision", ".so");
  }
  for (const auto& [name, library] : kOfEngines) {
    if (name == engine) files[library];
  }
  if (has_scripts(world, host)) {
    for (const char* const library : kOfPython) files[library];
  }
  if (world.drawn) files["layouts"] = plugin::part_file("layouts");
  if (world.floor.pixels) files["images"] = plugin::part_file("images");
  dl_iterate_phdr(
      [](dl_phdr_info* library, std::size_t, void* wanted) {
        const fs::path file(library->dlpi_name);
        const std::string name = file.filename().string();
        auto& of = *static_cast<std::map<std::string, fs::path>*>(wanted);
        const auto known = of.find(name.substr(0, name.find('.')));
        if (known != of.end()) known->second = file;
        return 0;
      },
      &files);
  std::vector<fs::path> all{own};
  for (const auto& [name, file] : files) {
    if (fs::exists(file)) all.push_back(file);
  }
  return all;
}

}  // namespace elsie::batch

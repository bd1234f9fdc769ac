// Binds elsie.World.
#include <filesystem>
#include <map>
#include <utility>

#include <pybind11/stl.h>

#include "elsie/check/doubts.h"
#include "elsie/files/write_whole.h"
#include "elsie/render/world_cameras.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/data_directories.h"
#include "elsie/world/reader.h"
#include "elsie/world/vocabulary.h"
#include "elsie/world/warnings.h"

#include "hosts.h"
#include "values.h"
#include "world.h"

namespace elsie::python {

world::ReadOptions reading_for(std::uint64_t seed) {
  world::ReadOptions options;
  options.seed = seed;
  options.data_directories = world::default_data_directories();
  options.check_plugins = true;
  return options;
}

World::World(std::string text, std::string file, std::shared_ptr<const plugin::Host> host)
    : host_(std::move(host)), document_(std::move(text), std::move(file), *host_, reading_for(1)) {}

std::unique_ptr<World> World::open(const std::string& file,
                                   std::shared_ptr<const plugin::Host> host) {
  const std::string found = world::find_document(file, world::default_data_directories());
  return made<World>(world::read_text(found), found, std::move(host));
}

world::World World::description(std::optional<std::uint64_t> seed,
                                std::optional<double> time_limit_s,
                                const std::vector<std::string>& edits) const {
  world::ReadOptions reading = reading_for(seed.value_or(1));
  const auto& drawn = description().drawn;
  const bool is_redrawn = drawn && drawn->by_run && reading.seed != 1;
  if (!is_redrawn && !time_limit_s && edits.empty()) return description();
  reading.time_limit_s = time_limit_s;
  reading.edits = edits;
  return world::parse_world(text(), file(), *host_, reading);
}

namespace {

/// The word for the members of the group of this name, at any depth; "" if there is none.
std::string members_of(const world::ElementSpec& spec, const std::string& group) {
  for (const world::ElementSpec& child : spec.children) {
    if (child.group && child.name == group) return child.members;
    const std::string inside = members_of(child, group);
    if (!inside.empty()) return inside;
  }
  return "";
}

/// The path of a new member of the list that a path leads to: "robots" and "robot" give
/// "robot[+]".
std::string path_of_new(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::size_t start = slash == path.npos ? 0 : slash + 1;
  const std::string last = path.substr(start);
  const std::string members = members_of(world::vocabulary(), last);
  return path.substr(0, start) + (members.empty() ? last : members) + "[+]";
}

/// What is allowed but doubtful, as (file, line, sentence). Makes all objects, and so finds what
/// only they refuse.
py::list warnings_of(const World& world) {
  const simulation::Simulation simulation(
      world.description(), *world.shared_host(),
      {.data_directories = world::default_data_directories(), .cameras = render::world_cameras});
  py::list found;
  for (const simulation::UnmadeEdits& unmade : simulation.check({})) {
    found.append(py::make_tuple(unmade.from, 0, unmade.sentence));
  }
  for (const world::Warning& warning : world::warnings(simulation.world())) {
    found.append(
        py::make_tuple(warning.location.file.text(), warning.location.line, warning.message));
  }
  for (const base::Problem& doubt : check::doubts(simulation)) {
    found.append(py::make_tuple(doubt.file, doubt.line, doubt.message));
  }
  return found;
}

py::list robot_ids(const world::World& world) {
  py::list ids;
  for (const world::Robot& robot : world.robots) ids.append(robot.id);
  return ids;
}

/// Writes the text where it may be in another folder than the world that was read.
void save(const World& world, const std::string& file) {
  files::write_whole_or_throw(file,
                              world.text_for(std::filesystem::path(file).parent_path().string()));
}

}  // namespace

void bind_worlds(py::module_& module) {
  py::class_<World>(module, "World", "The base of elsie.World.")
      .def(py::init([](const std::optional<std::string>& text, const std::string& file,
                       const std::vector<std::string>& plugins) {
             auto host = host_with(plugins);
             return text ? made<World>(*text, file, std::move(host))
                         : World::open(file, std::move(host));
           }),
           py::arg("text"), py::arg("file"), py::arg("plugins"))
      .def(py::init([](const World& other) {
             return made<World>(other.text(), other.file(), other.shared_host());
           }),
           py::arg("other"))
      .def_property_readonly("text", &World::text, "The text of the file, with the edits.")
      .def_property_readonly("file", &World::file, "The file that it was read from.")
      .def_property_readonly(
          "name", [](const World& self) { return self.description().name; },
          "Of the world, as in the file.")
      .def_property_readonly(
          "robots", [](const World& self) { return robot_ids(self.description()); },
          "Ids, in the order of all arrays with a row for each robot.")
      .def_property_readonly(
          "time_limit", [](const World& self) { return self.description().limits.time; },
          "Simulated time after which runs end, s.")
      .def_property_readonly(
          "step_s", [](const World& self) { return self.description().physics.step; },
          "A step of the physics, s.")
      .def_property_readonly(
          "control_steps",
          [](const World& self) { return self.description().physics.control_steps; },
          "Steps of the physics from one decision of the robots to the next.")
      .def("_value",
           [](const World& self, const std::string& path) {
             return value_at(self.description(), *self.shared_host(), path);
           })
      .def("_edit_all", [](World& self, const py::list& edits) { self.edit(texts_of(edits)); })
      .def("_warnings", &warnings_of)
      .def("_save_as", &save);
  module.def("text_of", [](const py::handle& value) { return text_of(value); });
  module.def("path_of_new", &path_of_new);
}

}  // namespace elsie::python

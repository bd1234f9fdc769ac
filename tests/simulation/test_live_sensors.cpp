// Sensors that are edited in a run, and sensors that fail in it: each that Elsie ships.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/plugin/parameters.h"
#include "elsie/render/world_cameras.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/reader.h"

#include "shipped.h"
#include "world_builder.h"

using namespace elsie;
using namespace elsie::test;
using simulation::Simulation;

namespace {

/// A robot with this sensor drives past all that sensors see.
std::string world_with(const std::string& sensor) {
  return R"(<world format="1" name="senses">
  <arena length="3" width="3"/>
  <floor colour="#f0f0f0"/>
  <patches><disc_patch id="spot" x="0.1" y="0" radius="0.2" colour="#202020"/></patches>
  <fields><field id="pheromone"/></fields>
  <lamps><lamp id="lamp" x="0.8" y="0.3" z="0.2" intensity="2"/></lamps>
  <obstacles><static_box id="box" x="0.5" y="0.1" length="0.2" width="0.3"/></obstacles>
  <resources><resource team="red" x="0.3" y="-0.3"/></resources>
  <robots>
    <robot id="r1" team="red" x="0" y="0">
      <sensors><)" +
         sensor + R"( id="s"/></sensors>
      <behaviors><wander/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
    <robot id="r2" team="blue" x="0.2" y="0.4">
      <behaviors><wander/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
  </robots>
  <limits time="10"/>
</world>)";
}

world::World sensor_world(const std::string& sensor, const std::vector<std::string>& edits = {}) {
  world::ReadOptions options;
  options.edits = edits;
  return world::parse_world(world_with(sensor), source_path("senses.xml"), shipped(), options);
}

Simulation simulation_of(const world::World& world) {
  simulation::Options options;
  options.cameras = render::world_cameras;
  return Simulation(world, shipped(), options);
}

/// What the sensor reads in a second, and where the robot then is.
std::vector<double> history(Simulation& simulation) {
  std::vector<double> all;
  for (int tenth = 0; tenth < 10; ++tenth) {
    advance(simulation, 10);
    const std::vector<double> now = numbers_of(simulation, 0, 0);
    all.insert(all.end(), now.begin(), now.end());
  }
  all.push_back(static_cast<double>(simulation.state_hash() >> 12U));
  return all;
}

/// Another value that the parameter may have, near its default; "" if there is none.
std::string other_value(const ParameterDeclaration& parameter) {
  const auto within = [&](double value) {
    return value >= std::max(parameter.lowest, parameter.facts.min) &&
           value <= std::min(parameter.highest, parameter.facts.max);
  };
  if (const bool* flag = std::get_if<bool>(&parameter.default_value))
    return *flag ? "false" : "true";
  for (const auto& choice : parameter.facts.choices) {
    if (choice != plugin::format_value(parameter.default_value)) return choice;
  }
  double usual = 0.0;
  if (const double* real = std::get_if<double>(&parameter.default_value)) {
    usual = *real;
  } else if (const auto* whole = std::get_if<std::int64_t>(&parameter.default_value)) {
    usual = static_cast<double>(*whole);
  } else {
    return "";
  }
  for (const double value : {usual / 2, usual * 2, usual + 1, usual - 1}) {
    if (value != usual && within(value) &&
        (parameter.type == ParameterType::real || value == std::round(value))) {
      return plugin::format_value(parameter.type == ParameterType::real
                                      ? ParameterValue(value)
                                      : ParameterValue(static_cast<std::int64_t>(value)));
    }
  }
  return "";
}

std::vector<std::string> sensors() {
  std::vector<std::string> names;
  for (const Declaration* sensor : shipped().all(PluginKind::sensor)) {
    names.push_back(sensor->name);
  }
  return names;
}

}  // namespace

TEST_CASE("A parameter that is set when a run begins acts as if the file had it: every sensor") {
  int tried = 0, seen = 0;
  for (const std::string& sensor : sensors()) {
    const Declaration& declaration = *shipped().find(PluginKind::sensor, sensor);
    for (const ParameterDeclaration& parameter : declaration.parameters) {
      const std::string value = other_value(parameter);
      if (value.empty()) continue;
      const std::string path = "robot[r1]/sensor[s]/@" + parameter.name;
      CAPTURE(path, value, sensor);
      Simulation before = simulation_of(sensor_world(sensor, {path + "=" + value}));
      Simulation edited = simulation_of(sensor_world(sensor));
      edited.edit(path, value);
      const std::vector<double> with_edit = history(edited);
      CHECK(with_edit == history(before));
      Simulation usual = simulation_of(sensor_world(sensor));
      seen += with_edit != history(usual) ? 1 : 0;
      ++tried;
    }
  }
  CHECK(tried >= 32);
  CHECK(seen >= 16);  // the others matter elsewhere only
}

TEST_CASE("A sensor whose every update is missed reads what its blank reading says") {
  for (const std::string& sensor : sensors()) {
    CAPTURE(sensor);
    Simulation simulation = simulation_of(
        sensor_world(sensor, {"robot[r1]/sensor[s]/failure[+]=<failure dropout=\"1\"/>"}));
    const std::vector<double> first = numbers_of(simulation, 0, 0);
    advance(simulation, 50);
    CHECK(numbers_of(simulation, 0, 0) == first);
  }
}

TEST_CASE("No shipped world breaks when all its sensors fail") {
  for (const auto& entry : std::filesystem::directory_iterator(source_path("worlds"))) {
    if (entry.path().extension() != ".xml") continue;
    CAPTURE(entry.path().string());
    world::ReadOptions options;
    options.data_directories = {source_path("")};
    const world::World sound = world::read_world(entry.path().string(), shipped(), options);
    if (std::none_of(sound.robots.begin(), sound.robots.end(),
                     [](const world::Robot& robot) { return !robot.sensors.empty(); })) {
      continue;
    }
    options.edits = {"robot[*]/sensor[*]/failure[+]=<failure dropout=\"1\"/>"};
    world::World world = world::read_world(entry.path().string(), shipped(), options);
    simulation::Options how;
    how.cameras = render::world_cameras;
    how.data_directories = options.data_directories;
    Simulation simulation(world, shipped(), how);
    advance(simulation, 100);
    CHECK(simulation.time_s() == Approx(100 * world.physics.step));
  }
}

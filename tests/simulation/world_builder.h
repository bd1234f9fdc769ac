// Small worlds put together in code, and plugins of a few lines to live in them.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include <unistd.h>

#include "elsie/api/behavior.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/description.h"

#include "shipped.h"

namespace elsie::test {

/// A behaviour whose answer a test hands in.
class Scripted final : public Behavior {
 public:
  using Answer = std::function<Response(const Perception&)>;
  explicit Scripted(std::shared_ptr<Answer> answer) : answer_(std::move(answer)) {}
  Response respond(const Perception& now) override { return (*answer_)(now); }

 private:
  std::shared_ptr<Answer> answer_;
};

/// A plugin of a test, whose objects `create` makes.
inline Declaration declaration_of(PluginKind kind, const std::string& name,
                                  std::function<std::unique_ptr<Component>()> create) {
  Declaration declaration;
  declaration.kind = kind;
  declaration.name = name;
  declaration.description = "For a test";
  declaration.create = std::move(create);
  return declaration;
}

/// A host with the shipped plugins and a behaviour "scripted" with the given answer.
class ScriptedHost {
 public:
  explicit ScriptedHost(Scripted::Answer answer) : host(shipped_directory()) {
    auto shared = std::make_shared<Scripted::Answer>(std::move(answer));
    Declaration declaration = declaration_of(
        PluginKind::behavior, "scripted", [shared] { return std::make_unique<Scripted>(shared); });
    declaration.events = {{"hello", "a test raises it"}};
    host.add(std::move(declaration));
  }
  plugin::Host host;
};

inline world::BehaviorUse behavior(const std::string& plugin, double priority = 1.0,
                                   Parameters parameters = {}) {
  world::BehaviorUse use;
  use.plugin = use.id = plugin;
  use.parameters = std::move(parameters);
  use.priority = priority;
  return use;
}

inline world::MountedUse beam(const std::string& id, double yaw_deg, Parameters parameters = {}) {
  world::MountedUse use;
  use.plugin = "beam_range";
  use.id = id;
  use.yaw_deg = yaw_deg;
  use.parameters = std::move(parameters);
  return use;
}

/// A file of its own for each test, gone at the end.
struct TemporaryFile {
  TemporaryFile() {
    std::string name = (std::filesystem::temp_directory_path() / "elsie-XXXXXX.csv").string();
    close(mkstemps(name.data(), 4));
    path = name;
  }
  ~TemporaryFile() { std::filesystem::remove(path); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  std::filesystem::path path;
};

/// A robot whose only behaviour decides.
inline world::Robot robot(const std::string& id, double x, double y, double heading_deg,
                          const world::BehaviorUse& only) {
  world::Robot robot;
  robot.id = id;
  robot.team = "red";
  robot.x = x;
  robot.y = y;
  robot.heading_deg = heading_deg;
  robot.behaviors.push_back(only);
  robot.coordinator.emplace();
  robot.coordinator->plugin = robot.coordinator->id = "arbiter_suppression";
  return robot;
}

/// A world with one robot "r1", which stands at the origin.
inline world::World one_robot(const world::BehaviorUse& only = behavior("scripted")) {
  world::World world;
  world.robots.push_back(robot("r1", 0, 0, 0, only));
  return world;
}

inline void advance(simulation::Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) {
    simulation.step();
  }
}

inline world::Obstacle box(const std::string& id, world::ObstacleKind kind, double x, double y) {
  world::Obstacle box;
  box.id = id;
  box.kind = kind;
  box.x = x;
  box.y = y;
  return box;
}

/// Fuzzy models of the behaviours that have some.
inline Parameters models(const std::string& name) {
  return {{"left_model", source_path("fuzzy_models/" + name + "_left.fcl")},
          {"right_model", source_path("fuzzy_models/" + name + "_right.fcl")}};
}

/// The numbers of a sensor's current reading.
inline std::vector<double> numbers_of(const simulation::Simulation& simulation, std::size_t robot,
                                      std::size_t sensor) {
  std::vector<double> numbers;
  simulation.visit_reading(robot, sensor, [&](const ReadingField& field) {
    for (std::size_t i = 0; i < field.count; ++i) {
      numbers.push_back(field.number(i));
    }
  });
  return numbers;
}

}  // namespace elsie::test

// The world in which plugins of versions.h are replaced.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "elsie/api/coordinator.h"
#include "elsie/api/remember.h"
#include "elsie/simulation/simulation.h"

#include "versions.h"
#include "wheels.h"
#include "world_builder.h"

namespace elsie::test {

using simulation::Replacement;
using simulation::ReplacementRefused;
using simulation::Simulation;

/// A robot with one behaviour, and a coordinator of the library.
inline world::Robot numbered_robot(const std::string& id, double y, const world::BehaviorUse& use) {
  world::Robot made = robot(id, 0.0, y, 0.0, use);
  made.coordinator->plugin = made.coordinator->id = "numbered_first";
  return made;
}

/// Commands the number "version" of its first member, and how often it was asked.
class Watcher final : public Coordinator, public Remembers {
 public:
  bool strict = false;  // otherwise "number" will do, too

  void equipped(std::span<const Member> members, const Perception&) override {
    const auto all = members[0].published();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) {
      return one.name == "version" || (!strict && one.name == "number");
    });
    if (found == all.end()) throw std::invalid_argument("its member publishes no 'version'");
    version_ = static_cast<std::size_t>(found - all.begin());
    asked_ = 0;
  }
  Motion coordinate(std::span<Member> members, const Perception&) override {
    members[0].respond();
    return WheelPair().motion(
        {0.01 * members[0].published(version_), 0.01 * static_cast<double>(++asked_)});
  }
  void remember(Memory& memory) override { memory("asked", asked_); }

 private:
  std::size_t version_ = 0;
  std::int64_t asked_ = 0;
};

class Holds final : public Behavior {
 public:
  Coordination* inside = nullptr;
  Response respond(const Perception& now) override { return inside->respond(now); }
};

/// Commands the place of "level" among the fields of the first reading.
class Looks final : public Behavior {
 public:
  void equipped(const Perception& example) override {
    const auto& fields = example.all_readings()[0].declaration->fields;
    place_ = 0.0;
    while (fields[static_cast<std::size_t>(place_)].name != "level") place_ += 1.0;
  }
  Response respond(const Perception&) override { return WheelPair().motion({place_, place_}); }

 private:
  double place_ = 0.0;
};

/// A world of version 1, and what the next versions make of it.
class Stage {
 public:
  explicit Stage(const world::BehaviorUse& use = behavior("numbered")) {
    world.robots.push_back(numbered_robot("r1", 0.0, use));
    versions.write(1);
  }

  Simulation& start() {
    plugin::Host made = versions.host();
    // These stay, whatever becomes of the library.
    made.add(declare<Watcher>(PluginKind::coordinator, "watcher", "Commands a published number",
                              parameter("strict", &Watcher::strict)));
    made.add(
        declare<Holds>(PluginKind::behavior, "holds", "Holds", holds_behaviors(&Holds::inside)));
    made.add(declare<Looks>(PluginKind::behavior, "looks", "Commands the place of a field"));
    host = std::make_shared<const plugin::Host>(std::move(made));
    simulation.emplace(world, *host);
    return *simulation;
  }
  /// The file takes over, or what it throws leaves the old plugins.
  Replacement replace() {
    auto next = std::make_shared<const plugin::Host>(versions.renewed(*host));
    const Replacement replacement = simulation->replace_plugins(*next);
    host = std::move(next);
    return replacement;
  }
  Replacement replace(int number, char mode = '-') {
    versions.write(number, mode);
    return replace();
  }
  std::string refusal(int number, char mode) {
    try {
      replace(number, mode);
    } catch (const ReplacementRefused& refused) {
      return refused.what();
    }
    return "it was taken";
  }
  /// A sensor of the library on each robot.
  void add_levels() {
    for (world::Robot& robot : world.robots) {
      world::MountedUse& level = robot.sensors.emplace_back();
      level.plugin = level.id = "level";
    }
  }
  WheelRates step() {
    simulation->step();
    return rates(simulation->robot(0).command);
  }

  Versions versions;
  world::World world;
  std::shared_ptr<const plugin::Host> host;
  std::optional<Simulation> simulation;
};

}  // namespace elsie::test

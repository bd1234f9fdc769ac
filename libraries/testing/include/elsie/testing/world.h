// A small world in a test.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/simulation/simulation.h"
#include "elsie/testing/plugins.h"

namespace elsie::testing {

struct WorldOptions {
  std::uint64_t seed = 1;
  std::vector<std::string> set{};  // "robot[r1]/@max_speed=0.3"; see world::ReadOptions::edits
};

///   World world = World::from_file("world.xml");
///   world.run_for(2.0);
///   CHECK(world.pose("r1").x > 0.5);
///
/// Robots are named by their ids. An unknown id throws std::invalid_argument with the nearest one.
class World {
 public:
  /// Throws world::WorldError with all mistakes of the world.
  static World from_file(const std::string& file, const WorldOptions& options = {},
                         const Plugins& plugins = Plugins::found());
  /// The same for text; files that it names are in the working directory.
  static World from_text(std::string_view xml, const WorldOptions& options = {},
                         const Plugins& plugins = Plugins::found());

  // Each throws simulation::PluginFault, which names plugin, robot and step.

  World& step(int steps = 1);
  World& run_for(double seconds);
  /// Steps until `reached` is true or the time is up; returns whether it was reached.
  bool run_until(const std::function<bool(const World&)>& reached, double seconds);
  /// Runs from the start until a goal or a limit ends the run.
  simulation::RunResult run();
  /// Returns to the start, with this seed; layouts of the world are drawn again.
  World& reset(std::uint64_t seed);

  double time_s() const { return simulation_->time_s(); }
  Pose pose(const std::string& robot) const { return this->robot(robot).pose; }
  simulation::RobotView robot(const std::string& id) const;
  /// The coordinator's notes about one of the robot's behaviours in the last decision.
  const TraceRow& trace(const std::string& robot, const std::string& behavior) const;
  /// The current reading of a robot's sensor, by the sensor's id. Throws std::invalid_argument when
  /// it is of another kind.
  template <class Reading>
  const Reading& reading(const std::string& robot, const std::string& sensor) const {
    return *static_cast<const Reading*>(reading(robot, sensor, ReadingKind::of<Reading>()));
  }
  /// The number of times that an event was raised so far on this robot, or ("") on any.
  int count(std::string_view event, std::string_view robot = "") const;
  /// A measure of the run so far by its name in RunResult::measures: "path_length_m", or one of a
  /// measure plugin. None when it has no value. Throws std::invalid_argument for an unknown name.
  std::optional<double> measured(const std::string& name) const;
  const simulation::Simulation& simulation() const { return *simulation_; }

 private:
  World(std::function<world::World(std::uint64_t seed)> read, const WorldOptions& options,
        const Plugins& plugins);
  void begin(std::uint64_t seed);
  std::size_t index_of(const std::string& robot) const;
  const void* reading(const std::string& robot, const std::string& sensor,
                      const ReadingKind& kind) const;

  Plugins plugins_;
  std::function<world::World(std::uint64_t seed)> read_;
  std::unique_ptr<simulation::Simulation> simulation_;
};

}  // namespace elsie::testing

// A world that runs.
//
//   const world::World world = world::read_world("clutter.xml", host);
//   simulation::Simulation simulation(world, host, {.seed = 7});
//   const simulation::RunResult result = simulation.run();
//
// One step: sensors -> each robot's coordinator and its behaviours -> energy -> motors -> physics
// -> collection, charging, goals. All robots decide on the same instant, before any of them moves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "elsie/api/coordinator.h"
#include "elsie/api/perception.h"
#include "elsie/api/sensor.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/fault.h"
#include "elsie/simulation/observer.h"
#include "elsie/simulation/run_result.h"
#include "elsie/world/description.h"

namespace elsie::simulation {

struct Options {
  std::uint64_t seed = 1;
  /// Measure how long each behaviour takes, for the trace. Changes nothing else.
  bool measure_time = false;
};

/// One sensor of a robot, to look at.
struct SensorView {
  std::string_view id;
  std::string_view plugin;
  const Sensor* sensor;
  const Mounting* mounting;
};

/// One robot at this instant, to look at.
struct RobotView {
  const world::Robot* description;
  const OwnState* state;            // as it was last perceived or, between steps, as it is now
  MotorCommand command;             // what its motors hold
  std::span<const Member> members;  // with the trace of the last decision
  double distance_m;                // driven so far
  int collisions;
  bool empty;  // the battery is
};

class Simulation {
 public:
  /// Makes all objects of the world and puts it at time zero. Throws world::WorldError when a
  /// plugin refuses its parameters, with the place in the world file.
  Simulation(world::World world, const plugin::Host& host, const Options& options = {});
  Simulation(Simulation&&) noexcept;
  ~Simulation();

  /// Back to time zero, with this seed or the one before. What follows is what a new simulation
  /// with that seed does.
  void reset(std::optional<std::uint64_t> seed = std::nullopt);

  /// One step. Throws PluginFault. After the end of the run it goes on all the same; the outcome
  /// stays.
  void step();

  /// Steps until a goal or a limit ends the run. Throws PluginFault.
  RunResult run(std::span<Observer* const> observers = {});

  /// What came of it so far.
  RunResult result() const;

  const world::World& world() const;
  double time_s() const;
  std::uint64_t steps() const;
  Outcome outcome() const;
  std::uint64_t state_hash() const;
  std::span<const EventRecord> events() const;

  std::size_t robots() const;
  RobotView robot(std::size_t index) const;
  std::size_t sensors(std::size_t robot) const;
  SensorView sensor(std::size_t robot, std::size_t index) const;
  /// Appends the numbers of a sensor's current reading, by name. Throws PluginFault.
  void list_values(std::size_t robot, std::size_t sensor, std::vector<NamedValue>& values) const;
  /// Where a sensor is in the world now.
  Frame sensor_frame(std::size_t robot, std::size_t index) const;
  /// Where a box is now; none when it was collected.
  std::optional<Pose> box(std::size_t index) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::simulation

// A robot at run time: its plugin objects, what it knows of itself, and one decision after the
// other.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elsie/api/coordinator.h"
#include "elsie/api/perception.h"
#include "elsie/api/sensor.h"
#include "elsie/physics/engine.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/description.h"

namespace elsie::simulation {

/// Time and identity of a control step, the same for all robots.
struct Instant {
  double time_s = 0.0;
  double period_s = 0.0;
  std::uint64_t step = 0;
};

class Robot final : private Member::Runner {
 public:
  /// Makes the plugin objects. Throws world::WorldError.
  Robot(const world::Robot& description, const plugin::Host& host, bool measure_time);
  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;

  /// Before a run: full battery, fresh random streams, plugin objects reset.
  void reset(std::uint64_t seed);

  /// Updates all sensors. Throws PluginFault.
  void sense(const Surroundings& surroundings, const Instant& now);
  /// Asks the coordinator; the command, limited to the maximum speed, is in command() afterwards.
  /// Throws PluginFault.
  void decide(const Instant& now);
  /// Discharges by what the sensors cost in a control period.
  void use_energy(double period_s);
  /// Charges for a control period, once a behaviour asked for it, until full. `rate`: units per
  /// second to be had where the robot is, or 0.
  void charge(double period_s, double rate);
  /// Takes over the body's state.
  void set_body(const physics::RobotState& state);
  /// The same after a step: counts the way too.
  void moved(const physics::RobotState& state);
  /// Adds energy of a collected resource, up to the capacity.
  void collect(double energy);

  /// An event for the next perception and for the log.
  void raise(std::string_view name, std::string detail = {});
  /// Appends the numbers of one sensor's reading. Throws PluginFault.
  void list_values(std::size_t sensor, std::vector<NamedValue>& values) const;
  /// Appends to the log the events since the last call.
  void take_log(double time_s, std::vector<EventRecord>& log);

  const world::Robot& description() const { return description_; }
  const OwnState& state() const { return state_; }
  TeamState& team() { return team_; }
  std::vector<TeamMate>& mates() { return mates_; }
  bool empty() const { return empty_; }
  const MotorCommand& command() const { return command_; }
  std::span<const Member> members() const { return members_; }
  double distance_m() const { return distance_m_; }
  int collected() const { return collected_; }
  int collisions() const { return collisions_; }
  void count_collision() { ++collisions_; }
  std::size_t sensor_count() const { return sensors_.size(); }
  SensorView sensor(std::size_t index) const;
  Frame sensor_frame(std::size_t index) const { return body_frame_.frame(sensors_[index].frame); }

 private:
  struct SensorSlot {
    const world::SensorUse* use;
    plugin::Object<Sensor> object;
    Mounting mounting;
    Frame frame;  // in the robot's frame
    Random random;
  };
  struct BehaviorSlot {
    const world::BehaviorUse* use;
    plugin::Object<Behavior> object;
    const Declaration* declaration;
    Random random;
    Response response;
  };
  struct Raised {
    Event event;
    std::string detail;
  };

  const Response& run(Member& member) override;
  void rate(Member& member, std::span<const MotorCommand> candidates,
            std::span<double> desirability) override;
  CommandSets command_sets(Member& member) override;
  void check(const BehaviorSlot& slot, const Response& response) const;
  void group_readings();
  void announce_equipment();
  void check_trace();
  void stop_when_empty();
  BehaviorSlot& slot_of(const Member& member) {
    return behaviors_[static_cast<std::size_t>(&member - members_.data())];
  }
  /// Runs code of a plugin; whatever it throws becomes a PluginFault with the plugin's name.
  template <class Action>
  decltype(auto) guarded(const world::PluginUse& use, Action action) const;
  [[noreturn]] void fail(const world::PluginUse& use, const std::string& problem) const;

  const world::Robot& description_;
  bool measure_time_;
  double sensor_cost_ = 0.0;  // units per second, of all sensors together

  std::vector<SensorSlot> sensors_;
  std::vector<BehaviorSlot> behaviors_;
  plugin::Object<Coordinator> coordinator_;
  Random coordinator_random_;
  std::vector<Member> members_;

  std::vector<SensedReading> sensed_;  // in groups of one kind
  std::vector<ReadingGroup> groups_;
  std::vector<TeamMate> mates_;
  std::vector<Event> perceived_events_;
  std::vector<Raised> raised_;  // since the last decision
  std::size_t logged_ = 0;      // how many of them the log has
  OwnState state_;
  TeamState team_;
  Perception::Data perception_;
  Frame body_frame_;
  MotorCommand command_;
  std::uint64_t step_ = 0;
  mutable std::optional<PluginFault> fault_;  // a coordinator may swallow it, but not the run

  bool charge_asked_ = false;
  bool empty_ = false;
  double distance_m_ = 0.0;
  int collected_ = 0;
  int collisions_ = 0;
};

}  // namespace elsie::simulation

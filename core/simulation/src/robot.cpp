#include "robot.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "elsie/plugin/parameters.h"
#include "elsie/world/error.h"

namespace elsie::simulation {
namespace {

/// What a plugin object refuses while the robot is put together is a fault of the world file.
template <class Action>
auto blaming(const world::PluginUse& use, Action action) {
  try {
    return action();
  } catch (const std::exception& problem) {
    throw world::WorldError(
        {{use.location.file, use.location.line, "plugin '" + use.plugin + "': " + problem.what()}});
  }
}

/// Makes and configures one plugin object.
template <class Kind>
plugin::Object<Kind> make(const plugin::Host& host, PluginKind kind, const world::PluginUse& use) {
  return blaming(use, [&] {
    const Declaration* declaration = host.find(kind, use.plugin);
    if (!declaration) {
      throw std::invalid_argument("no such plugin was found");
    }
    auto object = host.create<Kind>(kind, use.plugin);
    plugin::apply_parameters(*declaration, *object, use.parameters);
    return object;
  });
}

Mounting mounting_of(const world::SensorUse& use, const world::RobotBody& body) {
  return {{use.x.value_or(0.5 * body.length), use.y.value_or(0.0), use.z.value_or(body.top())},
          wrap_angle(radians(use.yaw_deg)),
          radians(use.pitch_deg)};
}

MotorCommand limited(const MotorCommand& command, double max_rate) {
  const double largest = std::max(std::abs(command.left), std::abs(command.right));
  return largest > max_rate ? (max_rate / largest) * command : command;
}

}  // namespace

Robot::Robot(const world::Robot& description, const plugin::Host& host, bool measure_time)
    : description_(description), measure_time_(measure_time) {
  for (const world::SensorUse& use : description.sensors) {
    const Mounting mounting = mounting_of(use, description.body);
    sensors_.push_back({&use, make<Sensor>(host, PluginKind::sensor, use), mounting,
                        Frame::turned(mounting.position, mounting.azimuth_rad, mounting.pitch_rad),
                        Random()});
    sensor_cost_ += use.energy_cost;
  }
  for (const world::BehaviorUse& use : description.behaviors) {
    behaviors_.push_back({&use, make<Behavior>(host, PluginKind::behavior, use), Random(), {}});
  }
  Member::Runner& runner = *this;
  for (BehaviorSlot& slot : behaviors_) {
    members_.emplace_back(slot.use->id, slot.use->priority, *slot.object, runner);
  }
  if (description.coordinator) {
    coordinator_ = make<Coordinator>(host, PluginKind::coordinator, *description.coordinator);
  }
  group_readings();

  state_.id = description.id;
  state_.wheel_radius_m = description.body.wheel_radius;
  state_.half_axle_m = description.body.half_axle();
  state_.length_m = description.body.length;
  state_.width_m = description.body.width;
  state_.max_speed_m_s = description.max_speed;
  state_.coverage_m = description.coverage;
  state_.is_leader = description.leader;
  state_.capacity = description.battery;
  team_.name = description.team;
  perception_.groups = groups_;
  perception_.self = &state_;
  perception_.team = &team_;
  announce_equipment();
}

void Robot::announce_equipment() {
  Random random;
  const Perception example(perception_, random);
  for (const BehaviorSlot& slot : behaviors_) {
    blaming(*slot.use, [&] { slot.object->equipped(example); });
  }
  if (coordinator_) {
    blaming(*description_.coordinator, [&] { coordinator_->equipped(members_, example); });
  }
}

void Robot::group_readings() {
  // Readings of one kind stand together, in file order, so that a behaviour gets them as one view.
  std::vector<ReadingKind> kinds;
  std::vector<ReadingKind> kind_of;
  for (const SensorSlot& slot : sensors_) {
    const ReadingKind kind = slot.object->kind();
    kind_of.push_back(kind);
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
      kinds.push_back(kind);
    }
  }
  sensed_.reserve(sensors_.size());
  for (const ReadingKind& kind : kinds) {
    const std::size_t first = sensed_.size();
    for (std::size_t i = 0; i < sensors_.size(); ++i) {
      if (kind_of[i] == kind) {
        sensed_.push_back(
            {sensors_[i].object->reading(), &sensors_[i].mounting, sensors_[i].use->id});
      }
    }
    groups_.push_back({kind, std::span(sensed_).subspan(first)});
  }
}

void Robot::reset(std::uint64_t seed) {
  const std::string path = "robot[" + description_.id + "]/";
  for (SensorSlot& slot : sensors_) {
    slot.random = Random(seed, path + "sensor[" + slot.use->id + "]");
    slot.object->reset();
  }
  for (BehaviorSlot& slot : behaviors_) {
    slot.random = Random(seed, path + "behavior[" + slot.use->id + "]");
    slot.response = {};
    slot.object->reset();
  }
  for (Member& member : members_) {
    member.begin_step();
  }
  if (coordinator_) {
    coordinator_random_ = Random(seed, path + "coordinator");
    coordinator_->reset();
  }
  state_.energy = description_.energy.value_or(description_.battery);
  state_.charging = false;
  command_ = {};
  perceived_events_.clear();
  raised_.clear();
  logged_ = 0;
  empty_ = false;
  distance_m_ = 0.0;
  collected_ = 0;
  collisions_ = 0;
  step_ = 0;
}

void Robot::sense(const Surroundings& surroundings, const Instant& now) {
  if (empty_) {
    return;
  }
  step_ = now.step;
  SensorContext context{now.time_s, now.period_s, {}, nullptr, &surroundings, nullptr};
  for (SensorSlot& slot : sensors_) {
    context.frame = body_frame_.frame(slot.frame);
    context.mounting = &slot.mounting;
    context.random = &slot.random;
    try {
      slot.object->update(context);
    } catch (const std::exception& problem) {
      fail(slot.use->plugin, problem.what());
    } catch (...) {
      fail(slot.use->plugin, "it threw something that is no std::exception");
    }
  }
}

void Robot::decide(const Instant& now) {
  step_ = now.step;
  perceived_events_.clear();
  for (const Raised& raised : raised_) {
    perceived_events_.push_back(raised.event);
  }
  raised_.clear();
  logged_ = 0;
  for (Member& member : members_) {
    member.begin_step();
  }
  if (empty_ || !coordinator_) {
    command_ = {};
    return;
  }
  perception_.time_s = now.time_s;
  perception_.period_s = now.period_s;
  perception_.events = perceived_events_;
  team_.mates = mates_;
  MotorCommand command;
  try {
    command = coordinator_->coordinate(members_, Perception(perception_, coordinator_random_));
  } catch (const PluginFault&) {
    throw;
  } catch (const std::exception& problem) {
    fail(description_.coordinator->plugin, problem.what());
  } catch (...) {
    fail(description_.coordinator->plugin, "it threw something that is no std::exception");
  }
  if (!command.is_finite()) {
    fail(description_.coordinator->plugin, "its command is not a finite number");
  }
  command_ = limited(command, state_.max_wheel_rate());
}

const Response& Robot::run(Member& member) {
  BehaviorSlot& slot = behaviors_[static_cast<std::size_t>(&member - members_.data())];
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = measure_time_ ? Clock::now() : Clock::time_point();
  try {
    slot.response = slot.object->respond(Perception(perception_, slot.random));
  } catch (const std::exception& problem) {
    fail(slot.use->plugin, problem.what());
  } catch (...) {
    fail(slot.use->plugin, "it threw something that is no std::exception");
  }
  if (measure_time_) {
    member.trace.time_s = std::chrono::duration<double>(Clock::now() - start).count();
  }
  check(slot, slot.response);
  for (const Event& event : slot.response.events) {
    raise(event.name);
  }
  if (slot.response.charge) {
    charge_asked_ = true;
  }
  return slot.response;
}

void Robot::check(const BehaviorSlot& slot, const Response& response) const {
  if (!response.command.is_finite()) {
    fail(slot.use->plugin, "its command is not a finite number");
  }
  if (!(response.activation >= 0.0 && response.activation <= 1.0)) {
    fail(slot.use->plugin,
         "its activation is " + std::to_string(response.activation) + ", which is not in [0, 1]");
  }
  if (!(response.strength >= 0.0 && response.strength <= 1.0)) {
    fail(slot.use->plugin,
         "its strength is " + std::to_string(response.strength) + ", which is not in [0, 1]");
  }
}

void Robot::fail(const std::string& plugin, const std::string& problem) const {
  throw PluginFault(plugin, description_.id, step_, problem);
}

void Robot::use_energy(double period_s, double at_charger_rate) {
  if (empty_) {
    return;
  }
  if (charge_asked_ && !state_.charging && at_charger_rate > 0.0 &&
      state_.energy < state_.capacity) {
    state_.charging = true;
    raise("charging_started");
  }
  charge_asked_ = false;
  state_.energy -= sensor_cost_ * period_s;
  if (state_.charging) {
    state_.energy += at_charger_rate * period_s;
    if (state_.energy >= state_.capacity || at_charger_rate <= 0.0) {
      state_.charging = false;
      raise("charging_ended");
    }
  }
  state_.energy = std::clamp(state_.energy, 0.0, state_.capacity);
  if (state_.energy <= 0.0 && sensor_cost_ > 0.0) {
    empty_ = true;
    command_ = {};
    raise("battery_empty");
  }
}

void Robot::moved(const physics::RobotState& state) {
  distance_m_ += distance(state_.pose, state.pose);
  set_body(state);
}

void Robot::set_body(const physics::RobotState& state) {
  body_frame_ = state.frame;
  state_.pose = state.pose;
  state_.wheel_rates = state.wheel_rates;
  state_.speed_m_s = state.speed;
  state_.turn_rate_rad_s = state.turn_rate;
}

void Robot::collect(double energy) {
  ++collected_;
  state_.energy = std::min(state_.capacity, state_.energy + energy);
  empty_ = empty_ && state_.energy <= 0.0;
}

void Robot::raise(std::string_view name, std::string detail) {
  raised_.push_back({{name}, std::move(detail)});
}

void Robot::take_log(double time_s, std::vector<EventRecord>& log) {
  for (; logged_ < raised_.size(); ++logged_) {
    log.push_back({time_s, description_.id, std::string(raised_[logged_].event.name),
                   raised_[logged_].detail});
  }
}

SensorView Robot::sensor(std::size_t index) const {
  const SensorSlot& slot = sensors_[index];
  return {slot.use->id, slot.use->plugin, slot.object.get(), &slot.mounting};
}

}  // namespace elsie::simulation

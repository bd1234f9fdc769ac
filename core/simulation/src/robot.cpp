#include "robot.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "elsie/plugin/parameters.h"
#include "elsie/world/error.h"

namespace elsie::simulation {
namespace {

/// What a plugin object refuses while the robot is put together is a fault of the world file.
template <class Action>
auto blaming(const world::PluginUse& use, std::vector<world::Problem>& problems, Action action)
    -> decltype(action()) {
  const auto blame = [&](const std::string& problem) {
    problems.push_back(
        {use.location.file, use.location.line, "plugin '" + use.plugin + "': " + problem});
  };
  try {
    return action();
  } catch (const std::exception& problem) {
    blame(problem.what());
  } catch (...) {
    blame("it threw something that is no std::exception");
  }
  return decltype(action())();
}

/// Makes and configures one plugin object; none when that fails.
template <class Kind>
plugin::Object<Kind> make(const plugin::Host& host, PluginKind kind, const world::PluginUse& use,
                          std::vector<world::Problem>& problems) {
  return blaming(use, problems, [&] {
    const Declaration* declaration = host.find(kind, use.plugin);
    if (!declaration) {
      throw std::invalid_argument("no such plugin was found");
    }
    auto object = host.create<Kind>(kind, use.plugin);
    plugin::apply_parameters(*declaration, *object, use.parameters);
    return object;
  });
}

void throw_if_any(const std::vector<world::Problem>& problems) {
  if (!problems.empty()) {
    throw world::WorldError(problems);
  }
}

Mounting mounting_of(const world::SensorUse& use, const world::RobotBody& body) {
  return {{use.x.value_or(0.5 * body.length), use.y.value_or(0.0), use.z.value_or(body.top())},
          wrap_angle(radians(use.yaw_deg)),
          radians(use.pitch_deg)};
}

std::string text(const MotorCommand& command) {
  return "left " + std::to_string(command.left) + ", right " + std::to_string(command.right);
}

MotorCommand limited(const MotorCommand& command, double max_rate) {
  const double largest = std::max(std::abs(command.left), std::abs(command.right));
  return largest > max_rate ? (max_rate / largest) * command : command;
}

}  // namespace

template <class Action>
decltype(auto) Robot::guarded(const world::PluginUse& use, Action action) const {
  try {
    return action();
  } catch (const PluginFault&) {
    throw;  // of another plugin, which this one had called
  } catch (const std::exception& problem) {
    fail(use, problem.what());
  } catch (...) {
    fail(use, "it threw something that is no std::exception");
  }
}

Robot::Robot(const world::Robot& description, const plugin::Host& host, bool measure_time)
    : description_(description), measure_time_(measure_time) {
  std::vector<world::Problem> problems;
  for (const world::SensorUse& use : description.sensors) {
    const Mounting mounting = mounting_of(use, description.body);
    sensors_.push_back({&use, make<Sensor>(host, PluginKind::sensor, use, problems), mounting,
                        Frame::turned(mounting.position, mounting.azimuth_rad, mounting.pitch_rad),
                        Random()});
    sensor_cost_ += use.energy_cost;
  }
  Member::Runner& runner = *this;
  for (const world::BehaviorUse& use : description.behaviors) {
    behaviors_.push_back({&use,
                          make<Behavior>(host, PluginKind::behavior, use, problems),
                          host.find(PluginKind::behavior, use.plugin),
                          Random(),
                          {}});
    members_.emplace_back(use.id, use.priority, runner);
  }
  if (description.coordinator) {
    coordinator_ =
        make<Coordinator>(host, PluginKind::coordinator, *description.coordinator, problems);
  }
  throw_if_any(problems);
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
  std::vector<world::Problem> problems;
  Random random;
  const Perception example(perception_, random);
  for (const BehaviorSlot& slot : behaviors_) {
    blaming(*slot.use, problems, [&] { slot.object->equipped(example); });
  }
  if (coordinator_) {
    blaming(*description_.coordinator, problems,
            [&] { coordinator_->equipped(members_, example); });
  }
  throw_if_any(problems);
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
  step_ = 0;
  fault_.reset();
  const std::string path = "robot[" + description_.id + "]/";
  for (SensorSlot& slot : sensors_) {
    slot.random = Random(seed, path + "sensor[" + slot.use->id + "]");
    slot.object->forget();
    guarded(*slot.use, [&] { slot.object->reset(); });
  }
  for (BehaviorSlot& slot : behaviors_) {
    slot.random = Random(seed, path + "behavior[" + slot.use->id + "]");
    slot.response = {};
    guarded(*slot.use, [&] { slot.object->reset(); });
  }
  for (Member& member : members_) {
    member.begin_step();
  }
  if (coordinator_) {
    coordinator_random_ = Random(seed, path + "coordinator");
    guarded(*description_.coordinator, [&] { coordinator_->reset(); });
  }
  state_.energy = description_.energy.value_or(description_.battery);
  state_.charging = false;
  command_ = {};
  perceived_events_.clear();
  raised_.clear();
  logged_ = 0;
  charge_asked_ = false;
  empty_ = false;
  distance_m_ = 0.0;
  collected_ = 0;
  collisions_ = 0;
  stop_when_empty();
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
    guarded(*slot.use, [&] { slot.object->update(context); });
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
  const MotorCommand command = guarded(*description_.coordinator, [&] {
    return coordinator_->coordinate(members_, Perception(perception_, coordinator_random_));
  });
  if (fault_) {
    throw *fault_;  // a member's, which the coordinator caught
  }
  if (!command.is_finite()) {
    fail(*description_.coordinator, "its command is not a finite number: " + text(command));
  }
  check_trace();
  command_ = limited(command, state_.max_wheel_rate());
}

const Response& Robot::run(Member& member) {
  BehaviorSlot& slot = slot_of(member);
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = measure_time_ ? Clock::now() : Clock::time_point();
  slot.response = guarded(
      *slot.use, [&] { return slot.object->respond(Perception(perception_, slot.random)); });
  if (measure_time_) {
    member.trace.time_s = std::chrono::duration<double>(Clock::now() - start).count();
  }
  check(slot, slot.response);
  for (const Event& event : slot.response.events) {
    raise(event.name);
  }
  charge_asked_ = charge_asked_ || slot.response.charge;
  return slot.response;
}

void Robot::rate(Member& member, std::span<const MotorCommand> candidates,
                 std::span<double> desirability) {
  const BehaviorSlot& slot = slot_of(member);
  guarded(*slot.use, [&] { slot.object->rate(slot.response, candidates, desirability); });
  for (const double degree : desirability) {
    if (!(degree >= 0.0 && degree <= 1.0)) {
      fail(*slot.use, "it rates a command " + std::to_string(degree) + ", which is not in [0, 1]");
    }
  }
}

CommandSets Robot::command_sets(Member& member) {
  const BehaviorSlot& slot = slot_of(member);
  CommandSets sets = guarded(*slot.use, [&] { return slot.object->command_sets(slot.response); });
  for (const FuzzySet* set : {&sets.left, &sets.right}) {
    double last = -std::numeric_limits<double>::infinity();
    for (const FuzzySet::Point& point : set->points) {
      if (!std::isfinite(point.x) || point.x < last ||
          !(point.degree >= 0.0 && point.degree <= 1.0)) {
        fail(*slot.use,
             "the points of its fuzzy sets are not in ascending order with degrees in [0, 1]");
      }
      last = point.x;
    }
  }
  return sets;
}

void Robot::list_values(std::size_t sensor, std::vector<NamedValue>& values) const {
  const SensorSlot& slot = sensors_[sensor];
  guarded(*slot.use, [&] { slot.object->list_values(values); });
}

void Robot::check(const BehaviorSlot& slot, const Response& response) const {
  if (!response.command.is_finite()) {
    fail(*slot.use, "its command is not a finite number: " + text(response.command));
  }
  const auto check_degree = [&](const char* what, double value) {
    if (!(value >= 0.0 && value <= 1.0)) {
      fail(*slot.use, std::string("its ") + what + " is " + std::to_string(value) +
                          ", which is not in [0, 1]");
    }
  };
  check_degree("activation", response.activation);
  check_degree("strength", response.strength);
  for (const Event& event : response.events) {
    const auto& declared = slot.declaration->events;
    if (std::none_of(declared.begin(), declared.end(),
                     [&](const EventDeclaration& d) { return d.name == event.name; })) {
      fail(*slot.use, "it raised the event '" + std::string(event.name) +
                          "', which its declaration does not name; add elsie::raises() to it");
    }
  }
}

void Robot::check_trace() {
  for (Member& member : members_) {
    if (member.trace.inhibited_by >= static_cast<int>(members_.size())) {
      fail(*description_.coordinator, "its trace says that member " +
                                          std::to_string(member.trace.inhibited_by) +
                                          " inhibits another, but there is none of that number");
    }
    if (!member.trace.reason) {
      member.trace.reason = "";
    }
  }
}

void Robot::fail(const world::PluginUse& use, const std::string& problem) const {
  fault_.emplace(use.plugin, use.id, description_.id, step_, problem);
  throw *fault_;
}

void Robot::use_energy(double period_s) {
  if (!empty_) {
    state_.energy = std::max(0.0, state_.energy - sensor_cost_ * period_s);
    stop_when_empty();
  }
}

void Robot::stop_when_empty() {
  if (state_.energy <= 0.0) {
    empty_ = true;
    command_ = {};
    raise("battery_empty");
  }
}

void Robot::charge(double period_s, double rate) {
  if (charge_asked_ && !empty_ && !state_.charging && rate > 0.0 &&
      state_.energy < state_.capacity) {
    state_.charging = true;
    raise("charging_started");
  }
  charge_asked_ = false;
  if (state_.charging) {
    state_.energy = std::min(state_.capacity, state_.energy + rate * period_s);
    if (state_.energy >= state_.capacity || rate <= 0.0 || empty_) {
      state_.charging = false;
      raise("charging_ended");
    }
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

#include "step/robot.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "elsie/plugin/call.h"
#include "elsie/world/error.h"
#include "elsie/world/parts.h"

#include "plugins/make_plugin.h"
#include "step/carrier.h"
#include "step/teams.h"

namespace elsie::simulation {
namespace {

void throw_if_any(const std::vector<base::Problem>& problems) {
  if (!problems.empty()) {
    throw world::WorldError(problems);
  }
}

Mounting mounting_of(const world::SensorUse& use, const world::RobotBody& body) {
  return {{use.x.value_or(0.5 * body.length), use.y.value_or(0.0), use.z.value_or(body.top())},
          wrap_angle(radians(use.yaw_deg)),
          radians(use.pitch_deg)};
}

}  // namespace

Robot::Membership Robot::membership(const world::World& world, std::size_t robot) {
  const world::Robot& description = world.robots[robot];
  Membership membership;
  for (std::size_t i = 0; i < robot; ++i) {
    membership.index += world.robots[i].team == description.team ? 1 : 0;
  }
  membership.charger = nearest_charger(world, description.team, {description.x, description.y});
  membership.resource_colours = simulation::resource_colours(world, description.team);
  return membership;
}

Robot::Robot(const world::Robot& description, const Membership& membership,
             const plugin::Host& host, const Options& options)
    : description_(&description), guard_(description.id, options.budget) {
  const plugin::Call call({.robot = description.id.c_str()});
  std::vector<base::Problem> problems;
  for (const world::SensorUse& use : description.sensors) {
    sensors_.push_back(make_sensor(use, host, problems));
  }
  controller_ = std::make_unique<Controller>(
      description, Controller::Setting{host, guard_, *this, names_, options.measure_time},
      problems);
  controller_->list_members("", 0, -1, trace_);
  make_drive(host, problems);
  throw_if_any(problems);
  group_readings();

  take_membership(membership);
  take_description();
  perception_.groups = groups_;
  perception_.self = &state_;
  perception_.team = &team_;
  for (const auto& each : sensors_) {
    SensorSlot& slot = *each;
    blaming(*slot.use, problems, [&] {
      slot.object->equipped({&slot.mounting, resource_colours_});
    });
  }
  controller_->equip(Perception(perception_, unused_random_), problems);
  throw_if_any(problems);
}

std::shared_ptr<Robot::SensorSlot> Robot::make_sensor(const world::SensorUse& use,
                                                      const plugin::Host& host,
                                                      std::vector<base::Problem>& problems) const {
  auto made = std::make_shared<SensorSlot>();
  SensorSlot& slot = *made;
  slot.use = &use;
  slot.energy_cost = use.energy_cost;
  slot.declaration = host.find(PluginKind::sensor, use.plugin);
  slot.object = make<Sensor>(host, PluginKind::sensor, use, problems);
  slot.mounting = mounting_of(use, description_->body);
  slot.frame =
      Frame::turned(slot.mounting.position, slot.mounting.azimuth_rad, slot.mounting.pitch_rad);
  if (slot.object) {
    slot.camera = blaming(use, problems, [&] { return slot.object->camera(); });
  }
  return made;
}

/// What is described and nobody changes but by an edit of it.
void Robot::take_membership(const Membership& membership) {
  state_.id = description_->id;
  state_.length_m = description_->body.length;
  state_.width_m = description_->body.width;
  state_.team_index = membership.index;
  state_.capacity = description_->battery;
  team_.name = description_->team;
  team_.charger = membership.charger;
  resource_colours_ = membership.resource_colours;
}

void Robot::make_drive(const plugin::Host& host, std::vector<base::Problem>& problems) {
  drive_use_.plugin = drive_use_.id = "differential";
  drive_use_.location = description_->location;
  const world::PluginUse& use = drive_use();
  drive_declaration_ = host.find(PluginKind::drive, use.plugin);
  drive_ = make<Drive>(host, PluginKind::drive, use, problems);
  if (!drive_) return;
  blaming(use, problems, [&] {
    const Chassis chassis = world::chassis_of(description_->body);
    BodyPlan plan = world::plan_of(chassis, *drive_);
    drive_check_ = world::DriveCheck(plan);
    state_.wheels = drive_->wheels(chassis);
    state_.channels = drive_->channels();
    joints_.assign(drive_check_.joints(), {});
    wanted_joints_ = joints_;
    if (description_->drive) driven_ = std::move(plan);
  });
}

void Robot::command(const Motion& asked) {
  asked_ = asked;
  carry_out(asked);
}

void Robot::carry_out(const Motion& motion) {
  const auto command = [&] {
    state_.commanded =
        drive_->command(motion, {joints_, state_.max_speed_m_s, period_s_}, wanted_joints_);
  };
  if (!description_->drive) {  // the core's own drive needs no guard
    command();
    if (!state_.commanded.is_finite()) {
      guard_.fail(drive_use(), "command() gives numbers that are not finite");
    }
    return;
  }
  const std::string problem = guard_.run(drive_use(), [&] {
    command();
    return drive_check_.problem(*drive_, state_.commanded, state_.max_speed_m_s, wanted_joints_);
  });
  if (!problem.empty()) guard_.fail(drive_use(), problem);
}

/// What may have changed since.
void Robot::take_description() {
  state_.max_speed_m_s = description_->max_speed;
  state_.coverage_m = description_->coverage;
  state_.is_leader = description_->leader;
  for (const auto& each : sensors_) {
    SensorSlot& slot = *each;
    slot.energy_cost = slot.use->energy_cost;
  }
  sum_costs();
}

void Robot::sum_costs() {
  sensor_cost_ = 0.0;
  for (const auto& each : sensors_) {
    const SensorSlot& slot = *each;
    sensor_cost_ += slot.energy_cost;
  }
}

void Robot::group_readings() {
  // Readings of one kind stand together, in file order, so that a behaviour gets them as one view.
  std::vector<ReadingKind> kinds;
  std::vector<ReadingKind> kind_of;
  for (const auto& each : sensors_) {
    const SensorSlot& slot = *each;
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
            {sensors_[i]->object->reading(), &sensors_[i]->mounting, sensors_[i]->use->id});
      }
    }
    groups_.push_back({kind, std::span(sensed_).subspan(first)});
  }
}

void Robot::reset(std::uint64_t seed) {
  guard_.begin_run();
  guard_.begin_step(0);
  take_description();
  if (const auto changed = tuning_.changed(); !changed.empty()) {
    for (const world::PluginUse* use : changed) {
      guard_.run(*use, [&] { tuning_.forget(object_of(*use), example()); });
    }
    look_through_cameras();
  }
  const std::string path = "robot[" + description_->id + "]/";
  for (const auto& each : sensors_) {
    SensorSlot& slot = *each;
    slot.random = Random(seed, path + "sensor[" + slot.use->id + "]");
    slot.object->forget();
    slot.picture = {};
    guard_.run(*slot.use, [&] { slot.object->reset(slot.random); });
  }
  drive_random_ = Random(seed, path + "drive");
  guard_.run(drive_use(), [&] { drive_->reset(drive_random_); });
  std::fill(joints_.begin(), joints_.end(), JointSetting{});
  wanted_joints_ = joints_;
  controller_->reset(seed, path);
  state_.energy = description_->energy.value_or(description_->battery);
  state_.charging = false;
  command({});
  perceived_events_.clear();
  raised_.clear();
  logged_ = 0;
  charge_asked_ = false;
  empty_ = false;
  distance_m_ = 0.0;
  energy_used_ = 0.0;
  collected_ = 0;
  collisions_ = 0;
  stop_when_empty();
}

void Robot::sense(const Carrier& carrier, const Instant& now) {
  if (empty_) {
    return;
  }
  guard_.begin_step(now.step);
  SensorContext context{now.time_s, now.period_s, {}, nullptr, &carrier, nullptr};
  for (const auto& each : sensors_) {
    SensorSlot& slot = *each;
    context.frame = body_frame_.frame(slot.frame);
    context.mounting = &slot.mounting;
    context.random = &slot.random;
    context.image = slot.camera ? &slot.picture : nullptr;
    guard_.step(*slot.use, [&] { slot.object->update(context); });
    slot.volume = carrier.take_volume();
  }
}

void Robot::decide(const Instant& now) {
  guard_.begin_step(now.step);
  perceived_events_.clear();
  for (const events::AnyEvent& event : raised_) {
    perceived_events_.push_back({names_.keep(events::name_of(event))});
  }
  raised_.clear();
  logged_ = 0;
  controller_->begin_step();
  period_s_ = now.period_s;
  if (empty_) {
    command({});
    return;
  }
  perception_.time_s = now.time_s;
  perception_.period_s = now.period_s;
  perception_.events = perceived_events_;
  team_.mates = mates_;
  command(controller_->decide(Perception(perception_, unused_random_)));
}

void Robot::ask(Statements& said) {
  for (const auto& each : sensors_) {
    const SensorSlot& slot = *each;
    said.ask(*slot.object, *slot.use, "", guard_);
  }
  controller_->ask("", said);
}

void Robot::list_values(std::size_t sensor, std::vector<NamedValue>& values) const {
  const SensorSlot& slot = *sensors_[sensor];
  guard_.run(*slot.use, [&] { slot.object->list_values(values); });
}

void Robot::use_energy(double period_s) {
  if (!empty_) {
    const double before = state_.energy;
    state_.energy = std::max(0.0, before - sensor_cost_ * period_s);
    energy_used_ += before - state_.energy;
    stop_when_empty();
  }
}

void Robot::stop_when_empty() {
  if (state_.energy <= 0.0) {
    empty_ = true;
    command({});
    raise(events::BatteryEmpty{});
  }
}

void Robot::set_max_speed(double max_speed) {
  state_.max_speed_m_s = max_speed;
  carry_out(state_.commanded);
}

void Robot::set_energy(double units) {
  const bool was_empty = empty_;
  state_.energy = units;
  empty_ = false;
  if (!was_empty) {
    stop_when_empty();
  } else {
    empty_ = units <= 0.0;
  }
}

void Robot::set_energy_cost(const world::PluginUse& sensor, double cost) {
  for (const auto& each : sensors_) {
    SensorSlot& slot = *each;
    if (slot.use == &sensor) {
      slot.energy_cost = cost;
    }
  }
  sum_costs();
}

std::optional<TunedObject> Robot::find_object(const world::PluginUse& use) {
  for (const auto& slot : sensors_) {
    if (slot->use == &use) {
      return own_object(*slot);
    }
  }
  if (&use == &drive_use()) {
    return TunedObject{PluginKind::drive, &use, drive_declaration_, drive_.get(), {}, {}};
  }
  return controller_->object_of(use);
}

std::optional<Camera> Robot::try_out(const world::PluginUse& use, const Setup& setup) {
  return Tuning::try_out(object_of(use), setup, example());
}

void Robot::set_up(const world::PluginUse& use, const Setup& setup) {
  const TunedObject tuned = object_of(use);
  const Setup before = tuning_.setup(use);
  try {
    tuning_.set(tuned, setup, example());
  } catch (...) {
    guard_.run(use, [&] { tuning_.set(tuned, before, example()); });
    throw;
  }
  look_through_cameras();
}

/// The perception for plugins that get new parameters: what was perceived last.
Perception Robot::example() {
  team_.mates = mates_;
  perception_.events = perceived_events_;
  return {perception_, unused_random_};
}

void Robot::look_through_cameras() {
  for (const auto& each : sensors_) {
    SensorSlot& slot = *each;
    if (slot.camera) {
      slot.camera = guard_.run(*slot.use, [&] { return slot.object->camera(); });
    }
  }
}

void Robot::charge(double period_s, double rate) {
  if (charge_asked_ && !empty_ && !state_.charging && rate > 0.0 &&
      state_.energy < state_.capacity) {
    state_.charging = true;
    raise(events::ChargingStarted{});
  }
  charge_asked_ = false;
  if (state_.charging) {
    state_.energy = std::min(state_.capacity, state_.energy + rate * period_s);
    if (state_.energy >= state_.capacity || rate <= 0.0 || empty_) {
      state_.charging = false;
      raise(events::ChargingEnded{});
    }
  }
}

void Robot::moved(const physics::RobotState& state, std::span<const JointSetting> joints) {
  distance_m_ += distance(state_.pose, state.pose);
  set_body(state, joints);
}

void Robot::set_body(const physics::RobotState& state, std::span<const JointSetting> joints) {
  std::copy(joints.begin(), joints.end(), joints_.begin());
  Turret turret;
  if (description_->drive) {
    guard_.run(drive_use(), [&] {
      turret = drive_->turret(joints_);
      state_.odometry = drive_->odometry(joints_);
    });
    if (!state_.odometry.is_finite() || !std::isfinite(turret.angle_rad + turret.turn_rad_s)) {
      guard_.fail(drive_use(), "odometry() or turret() gives numbers that are not finite");
    }
  } else {  // the core's own drive needs no guard
    state_.odometry = drive_->odometry(joints_);
  }
  body_frame_ = state.frame;
  state_.pose = state.pose;
  state_.moving = {state.speed, state.lateral, state.turn_rate + turret.turn_rad_s};
  if (turret.angle_rad != 0.0) {
    const double c = std::cos(turret.angle_rad), s = std::sin(turret.angle_rad);
    body_frame_ = state.frame.frame(Frame::turned({}, turret.angle_rad, 0.0));
    state_.pose.heading_rad = wrap_angle(state.pose.heading_rad + turret.angle_rad);
    state_.moving.forward = c * state.speed + s * state.lateral;
    state_.moving.lateral = c * state.lateral - s * state.speed;
  }
}

void Robot::collect(double energy) {
  ++collected_;
  state_.energy = std::min(state_.capacity, state_.energy + energy);
  empty_ = empty_ && state_.energy <= 0.0;
}

void Robot::take_log(double time_s, std::vector<EventRecord>& log) {
  for (; logged_ < raised_.size(); ++logged_) {
    log.push_back({time_s, description_->id, raised_[logged_]});
  }
}

SensorView Robot::sensor(std::size_t index) const {
  const SensorSlot& slot = *sensors_[index];
  return {slot.use->id,
          slot.use->plugin,
          slot.object.get(),
          &slot.mounting,
          slot.camera ? &*slot.camera : nullptr,
          slot.picture.empty() ? nullptr : &slot.picture,
          slot.volume ? &*slot.volume : nullptr};
}

}  // namespace elsie::simulation

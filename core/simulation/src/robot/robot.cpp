#include "robot/robot.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "elsie/plugin/call.h"
#include "elsie/world/error.h"
#include "elsie/world/parts.h"

#include "edits/transaction.h"
#include "robot/robot_surroundings.h"
#include "step/teams.h"

namespace elsie::simulation {
namespace {

void throw_if_any(const std::vector<base::Problem>& problems) {
  if (!problems.empty()) throw world::WorldError(problems);
}

Mounting mounting_of(const world::MountedUse& use, const world::Robot& robot) {
  double front = 0.5 * robot.body.length, top = robot.body.top();
  int segment = 0;
  if (!use.segment.empty()) {
    const std::size_t index = index_of(robot.segments, use.segment, 0);
    const world::Segment& carrier = robot.segments.at(index);
    front = 0.5 * carrier.length;
    top = carrier.clearance + carrier.height;
    segment = static_cast<int>(index) + 1;
  }
  return {{use.x.value_or(front), use.y.value_or(0.0), use.z.value_or(top)},
          wrap_angle(radians(use.yaw_deg)),
          radians(use.pitch_deg),
          segment};
}

}  // namespace

Robot::Robot(const world::World& world, std::size_t index,
             const std::shared_ptr<CommonData>& common, const plugin::Host& host,
             const Options& options)
    : description_(&world.robots[index]),
      guard_(description_->id, options.budget),
      common_(common) {
  const world::Robot& description = *description_;
  const plugin::Call call({.robot = &description.id});
  std::vector<base::Problem> problems;
  sensors_.reserve(description.sensors.size());
  for (const world::MountedUse& use : description.sensors) {
    sensors_.push_back(std::make_shared<SensorSlot>(use, host, *this));
  }
  // One after the other, so that they are near each other in memory.
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    make_mounted(*sensors_[i], description.sensors[i], host, problems);
  }
  for (const world::MountedUse& use : description.actuators) {
    actuators_.push_back(std::make_shared<ActuatorSlot>(use, host, *this));
    make_mounted(*actuators_.back(), use, host, problems);
  }
  controller_.emplace(description, host, Controller::Setting{guard_, *this, options.measure_time},
                      problems);
  make_drive(host, problems);
  make_localisation(host, problems);
  throw_if_any(problems);
  group_readings();

  take_membership(world, index, *common);
  state_.max_speed_m_s = description.max_speed;
  state_.coverage_m = description.coverage;
  state_.is_leader = description.leader;
  perception_.self = &state_;
  perception_.team = &team_;
  for_each(Order::inner_first, [&](PluginObject& each, const auto&, const auto&) {
    blaming(*each.use, problems, [&] { each.equip(*each.held, example()); });
  });
  throw_if_any(problems);
}

void Robot::for_each(Order order, const Visit& visit) const {
  for (const auto& slot : sensors_) visit(*slot, "sensor[" + slot->use->id + "]", "");
  for (const auto& slot : actuators_) visit(*slot, "actuator[" + slot->use->id + "]", "");
  visit(*drive_, "drive", "");
  if (localisation_) visit(*localisation_, "localisation", "");
  controller_->for_each(order, "", "", visit);
}

const world::PluginUse& Robot::drive_use() const {
  static const world::PluginUse kDefault{"differential", "differential", {}, {}, {}, {}};
  return description_->drive ? *description_->drive : kDefault;
}

template <class Slot>
void Robot::make_mounted(Slot& slot, const world::MountedUse& use, const plugin::Host& host,
                         std::vector<base::Problem>& problems) const {
  slot.make(host, problems);
  slot.place = &common_->place(mounting_of(use, *description_));
  if (!slot.held) return;
  if (const auto camera = blaming(use, problems, [&] { return slot.camera_of(slot.object()); })) {
    slot.own_extras().camera = camera;
  }
}
template void Robot::make_mounted(SensorSlot&, const world::MountedUse&, const plugin::Host&,
                                  std::vector<base::Problem>&) const;
template void Robot::make_mounted(ActuatorSlot&, const world::MountedUse&, const plugin::Host&,
                                  std::vector<base::Problem>&) const;

/// Copies what only an edit of the description changes, and data of the team: the robot's index,
/// whether there is a charger, and the colours of the resources that it may collect.
void Robot::take_membership(const world::World& world, std::size_t index, CommonData& common) {
  const world::Robot& robot = *description_;
  state_.id = robot.id;
  state_.length_m = robot.body.length;
  state_.width_m = robot.body.width;
  state_.team_index = common.number_of(index);
  state_.capacity = robot.battery;
  team_.name = robot.team;
  team_.charger = nearest_charger(world, robot.team, {robot.x, robot.y});
  team_.nest = nearest_nest(world, robot.team, {robot.x, robot.y});
  resource_colours_ = common.resource_colours(world, robot.team);
}

void Robot::make_drive(const plugin::Host& host, std::vector<base::Problem>& problems) {
  const Chassis chassis = world::chassis_of(description_->body);
  std::shared_ptr<DriveSlot> own;
  std::shared_ptr<DriveSlot>& drive =
      description_->drive ? own : common_->drives[{chassis.wheel_radius, chassis.half_axle}];
  if (!drive) {
    drive = std::make_shared<DriveSlot>(drive_use(), host);
    drive->make(host, problems);
  }
  drive_ = drive;
  if (!drive_->held) return;
  world::PluginUse blamed = drive_use();
  if (!description_->drive) blamed.location = description_->location;
  blaming(blamed, problems, [&] {
    BodyPlan plan = world::plan_of(chassis, drive_->object());
    world::DriveCheck check(plan);
    state_.wheels = drive_->object().wheels(chassis);
    state_.channels = drive_->object().channels();
    vehicles_ = plan.vehicles();
    joint_count_ = static_cast<std::uint32_t>(check.joints());
    joints_.assign(2 * check.joints(), {});
    if (!description_->drive) return;
    drive_->joints = joints_of(plan);
    drive_check_ = std::move(check);
    driven_ = std::move(plan);
  });
}

void Robot::make_localisation(const plugin::Host& host, std::vector<base::Problem>& problems) {
  localisation_.reset();
  if (description_->localisation) {
    localisation_ = std::make_shared<LocalisationSlot>(*description_->localisation, host);
    localisation_->make(host, problems);
  }
  localiser_ = localisation_.get();
}

void Robot::SensorSlot::equip(Component& object, const Example& example) const {
  auto& sensor = static_cast<Sensor&>(object);
  sensor.equipped({&place->mounting, example.resource_colours});
  fit_disturbances(*this, sensor, "sensor");
}

void Robot::ActuatorSlot::equip(Component& object, const Example& /*example*/) const {
  auto& actuator = static_cast<Actuator&>(object);
  actuator.equipped(place->mounting);
  static const std::vector<std::string> kHeard{"distance", "bearing", "elevation"};
  fit_disturbances(*this, actuator, "actuator",
                   declaration->hears_messages ? kHeard : std::vector<std::string>());
}

template <class Slot>
void Robot::fit_disturbances(const Slot& slot, Disturbable& object, const char* list,
                             const std::vector<std::string>& others) {
  const bool has_other_sizes = object.fit_value();
  DisturbedValue::check(object, others);
  if (&object != slot.held.get()) return;  // it is only tried
  if (!slot.disturbed) {
    if (object.disturbances().empty()) return;
    slot.disturbed = std::make_unique<DisturbedValue>();
    slot.disturbed->reset(slot.robot.seed_, "robot[" + slot.robot.description_->id + "]/" + list +
                                                "[" + slot.use->id + "]");
  }
  slot.disturbed->fit(object, has_other_sizes);
}

void Robot::group_readings() {
  // Readings of one kind are adjacent, in file order, so that a behaviour gets them as one view.
  std::vector<ReadingKind> kinds;
  std::vector<ReadingKind> kind_of;
  for (const auto& slot : sensors_) {
    const ReadingKind kind = kind_of.emplace_back(slot->object().kind());
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
  }
  sensed_.clear();
  groups_.clear();
  sensed_.reserve(sensors_.size());
  for (const ReadingKind& kind : kinds) {
    const std::size_t first = sensed_.size();
    const ReadingDeclaration* declaration = nullptr;
    for (std::size_t i = 0; i < sensors_.size(); ++i) {
      if (kind_of[i] == kind) {
        SensorSlot& slot = *sensors_[i];
        if (!declaration) declaration = &slot.declaration->produces.front();
        slot.sensed = sensed_.size();
        sensed_.push_back({slot.object().reading(), &slot.place->mounting, slot.use->id.c_str(),
                           slot.disturbed ? slot.disturbed->age_s() : 0.0});
      }
    }
    groups_.push_back({kind, std::span(sensed_).subspan(first), declaration});
  }
  perception_.groups = groups_;
  group_sensors();
}

void Robot::group_sensors() {
  driver_ = &drive_->object();
  has_default_drive_ = !description_->drive;
  entries_.clear();
  entries_.reserve(sensors_.size());
  for (const auto& slot : sensors_) {
    entries_.push_back({&slot->object(), slot->place, &slot->random});
  }
  together_.clear();
  mounted_cost_.reset();
  may_share_threads_ = true;
  const auto is_on_segment = [](const auto& slot) { return slot->place->mounting.segment > 0; };
  segments_.resize(std::any_of(sensors_.begin(), sensors_.end(), is_on_segment)
                       ? description_->segments.size()
                       : 0);
  state_.hears_messages = std::any_of(actuators_.begin(), actuators_.end(), [](const auto& slot) {
    return slot->declaration->hears_messages;
  });
  feels_contacts_ = std::any_of(sensors_.begin(), sensors_.end(),
                                [](const auto& slot) { return slot->declaration->feels_contacts; });
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const SensorSlot& slot = *sensors_[i];
    if (i > 0 && slot.declaration == sensors_[i - 1]->declaration &&
        slot.place->mounting.segment == sensors_[i - 1]->place->mounting.segment &&
        slot.declaration->updates_all && !slot.extras().camera) {
      ++together_.back().count;
    } else {
      together_.push_back({i, 1});
    }
  }
  for_each(Order::outer_first, [this](PluginObject& each, const auto&, const auto&) {
    may_share_threads_ = may_share_threads_ && each.declaration->may_share_threads;
  });
}

void Robot::reset(std::uint64_t seed) {
  seed_ = seed;
  guard_.begin_run();
  guard_.begin_step(0, 0.0);
  for_each(Order::inner_first, [&](PluginObject& each, const std::string& path, const auto&) {
    if (guard_.has_budget()) each.own_extras();  // outside of all calls, to which it would count
    guard_.run(*each.use, [&] { each.reset(seed, "robot[" + description_->id + "]/" + path); });
  });
  std::fill(joints_.begin(), joints_.end(), JointSetting{});
  controller_->begin_run();
  state_.energy = description_->energy.value_or(description_->battery);
  state_.charging = false;
  command({});
  perceived_events_.clear();
  raised_.clear();
  contacts_.clear();
  rolled_ = {};
  heard_.clear();
  perception_.heard = {};
  set_held({});
  for (const auto& slot : actuators_) {
    slot->by.clear();
    slot->under_way.clear();
    slot->sounding.clear();
    slot->deposits.clear();
    slot->effect = slot->shown = {};
  }
  logged_ = 0;
  charge_asked_ = false;
  empty_ = false;
  tally_ = {};
  stop_when_empty();
}

void Robot::fetch(bool objects) const {
  for (const auto& slot : sensors_) {
    const void* const first = objects ? static_cast<const void*>(&slot->object()) : slot.get();
    for (const int line : {0, 64}) __builtin_prefetch(static_cast<const char*>(first) + line);
  }
}

void Robot::sense(const RobotSurroundings& surroundings, const Instant& now) {
  if (empty_) {
    contacts_.clear();
    for (const auto& slot : sensors_) {
      if (!slot->disturbed) continue;
      slot->disturbed->wait(now.period_s);
      sensed_[slot->sensed].age_s = slot->disturbed->age_s();
    }
    return;
  }
  guard_.begin_step(now.step, now.time_s);
  for (const Together& group : together_) {
    SensorSlot& first = *sensors_[group.first];
    if (group.count == 1) {
      update(first, surroundings, now);
    } else {
      std::vector<RayQuery>& rays = surroundings.memory().rays;
      if (rays.size() < group.count) rays.resize(group.count);
      const SensorBatch all{std::span(entries_).subspan(group.first, group.count),
                            now.time_s,
                            now.period_s,
                            frame_below(*first.place),
                            &surroundings,
                            std::span(rays).first(group.count)};
      guard_.step(first, [&] { first.object().update_all(all); });
    }
    for (std::size_t i = group.first; i < group.first + group.count; ++i) {
      SensorSlot& slot = *sensors_[i];
      if (!slot.disturbed) continue;
      guard_.run(*slot.use,
                 [&] { slot.disturbed->update(slot.object(), now.time_s, now.period_s); });
      sensed_[slot.sensed].age_s = slot.disturbed->age_s();
    }
  }
  contacts_.clear();
  rolled_ = {};
}

void Robot::touched(std::span<const physics::BodyContact> contacts) {
  for (const physics::BodyContact& each : contacts) {
    const auto kind = each.other.kind == physics::BodyKind::robot      ? Surface::Kind::robot
                      : each.other.kind == physics::BodyKind::obstacle ? Surface::Kind::obstacle
                                                                       : Surface::Kind::wall;
    contacts_.push_back(
        {each.vehicle < vehicles_ ? 0 : static_cast<int>(each.vehicle - vehicles_) + 1,
         {kind, each.other.index, each.normal},
         each.point,
         each.normal,
         each.pressing()});
  }
}

void Robot::update(SensorSlot& slot, const RobotSurroundings& surroundings, const Instant& now) {
  const PluginObject::Extras& extras = slot.extras();
  const SensorContext context{now.time_s,
                              now.period_s,
                              frame_of(*slot.place),
                              &slot.place->mounting,
                              &surroundings,
                              &slot.random,
                              extras.camera ? extras.picture.get() : nullptr};
  guard_.step(slot, [&] { slot.object().update(context); });
}

void Robot::decide(const Instant& now) {
  guard_.begin_step(now.step, now.time_s);
  perceived_events_.clear();
  for (const events::AnyEvent& event : raised_) {
    perceived_events_.push_back({std::string(events::name_of(event))});
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
  if (!has_default_drive_ && drive_->disturbed) {
    guard_.run(drive_use(), [&] {
      drive_->disturbed->update(std::span(joints_).subspan(joint_count_), now.time_s, now.period_s);
    });
  }
}

void Robot::ask(Statements& said) {
  for_each(Order::outer_first, [&](PluginObject& each, const auto&, const std::string& within) {
    if (each.kind != PluginKind::drive) said.ask(each, within, guard_);
  });
}

void Robot::use_energy(double period_s) {
  if (!empty_) {
    if (!mounted_cost_) {
      mounted_cost_ = 0.0;
      for (const auto* uses : {&description_->sensors, &description_->actuators}) {
        for (const world::MountedUse& use : *uses) {
          *mounted_cost_ += use.energy_cost;
        }
      }
    }
    double power = *mounted_cost_;
    for (const auto& slot : actuators_) {
      power += slot->effect.power;
    }
    const double before = state_.energy;
    state_.energy = std::max(0.0, before - power * period_s);
    tally_.energy_used += before - state_.energy;
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

PluginObject* Robot::find_object(const world::PluginUse& use) const {
  PluginObject* found = nullptr;
  for_each(Order::outer_first, [&](PluginObject& each, const auto&, const auto&) {
    found = each.use == &use ? &each : found;
  });
  return found;
}

Component& Robot::object(const world::PluginUse& use) const {
  if (const PluginObject* const found = find_object(use)) return *found->held;
  throw std::invalid_argument("the plugin '" + use.plugin + "' is not part of the robot '" +
                              description_->id + "'");
}

void Robot::set_up(PluginObject& object, const Setup& setup) {
  const Setup before = object.completed(object.setup(), setup);
  try {
    object.set(setup, example());
  } catch (...) {
    guard_.run(*object.use, [&] { object.set(before, example()); });
    throw;
  }
}

/// The last perception, for plugins that get new parameters.
Example Robot::example() {
  team_.mates = mates_;
  perception_.events = perceived_events_;
  return {{perception_, unused_random_}, resource_colours_};
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

void Robot::collect(double energy) {
  ++tally_.collected;
  state_.energy = std::min(state_.capacity, state_.energy + energy);
  empty_ = empty_ && state_.energy <= 0.0;
}

void Robot::take_log(double time_s, std::vector<EventRecord>& log) {
  for (; logged_ < raised_.size(); ++logged_) {
    log.push_back({time_s, description_->id, raised_[logged_]});
  }
}

}  // namespace elsie::simulation

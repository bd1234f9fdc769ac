// The parts of robots and controllers that become what an edited world describes.
#include <algorithm>
#include <memory>
#include <string>

#include "elsie/plugin/parameters.h"
#include "elsie/world/same.h"

#include "changes/becoming.h"
#include "step/commons.h"
#include "step/controller.h"
#include "step/robot.h"

namespace elsie::simulation {
namespace {

/// Returns whether parameters differ that cannot change during a run.
bool differ_for_good(const std::vector<ParameterDeclaration>& declared,
                     const std::map<std::string, ParameterValue>& a,
                     const std::map<std::string, ParameterValue>& b) {
  const auto value = [](const auto& values, const ParameterDeclaration& of) {
    const auto known = values.find(of.name);
    return known == values.end() ? of.default_value : known->second;
  };
  return std::any_of(declared.begin(), declared.end(), [&](const ParameterDeclaration& one) {
    return !one.facts.live && value(a, one) != value(b, one);
  });
}

void equip(PluginObject& each, const std::optional<Setup>& setup, Memory memory,
           const Example& example) {
  if (setup) {
    plugin::apply_parameters(*each.declaration, *each.held, setup->parameters, setup->elements);
  }
  each.equip(*each.held, example);
  if (auto* const remembers = dynamic_cast<Remembers*>(each.held.get())) {
    remembers->remember(memory);
  }
}

}  // namespace

bool Becoming::keeps(PluginObject& object, const world::PluginUse& was,
                     const world::PluginUse& next) {
  if (!world::same(was, next)) {
    const Declaration& declaration = *object.declaration;
    if (was.plugin != next.plugin || was.id != next.id ||
        differ_for_good(declaration.parameters, was.parameters, next.parameters) ||
        !std::equal(was.elements.begin(), was.elements.end(), next.elements.begin(),
                    next.elements.end(), [&](const ElementValue& one, const ElementValue& other) {
                      const auto* known = plugin::find_declared(declaration.elements, one.element);
                      return one.element == other.element &&
                             !differ_for_good(known->parameters, one.parameters, other.parameters);
                    })) {
      return false;
    }
    const Setup before = as_described(was), now = as_described(next);
    again_with_[&object] = {object.completed(before, now), object.completed(now, before)};
  }
  describe(object, next);
  return true;
}

void Becoming::equip_again(PluginObject& object, const Example& example) {
  const Tuned tuned = has_other(object) ? again_with_.at(&object) : Tuned();
  blaming(*object.use, problems_, [&] {
    if (tuned.now) {
      object.try_out(*tuned.now, example);
    }
    const Memory memory = memory_of(*object.held);
    again_->push_back([&object, before = tuned.before, memory, example] {
      std::vector<base::Problem> ignored;
      blaming(*object.use, ignored, [&] { equip(object, before, memory, example); });
    });
    equip(object, tuned.now, memory, example);
  });
}

std::vector<Member> Controller::copied_members() {
  Member::Runner& runner = *this;
  std::vector<Member> copies;
  for (const Member& member : members_) {
    copies.emplace_back(member.name(), member.priority(), runner).trace = member.trace;
  }
  return copies;
}

/// Members keep their addresses if their number does not change.
void Controller::take_members(std::vector<Member> members) {
  if (members.size() == members_.size()) {
    std::move(members.begin(), members.end(), members_.begin());
  } else {
    members_ = std::move(members);
  }
}

void Controller::describe(const world::Coordination& next) {
  description_ = &next;
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    slots_[i]->use = &next.behaviors[i];
    if (slots_[i]->inside) slots_[i]->inside->describe(inside_of(next.behaviors[i]));
  }
  if (coordinator_) coordinator_->use = &*next.coordinator;
}

void Controller::become(const world::Coordination& was, const world::Coordination& next,
                        const std::string& path, Becoming& becoming) {
  Undo& undo = becoming.undo();
  const std::string& robot = setting_.guard.robot();
  // Added before the slots of the members, so it is undone after them.
  const auto members = std::make_shared<std::vector<Member>>(copied_members());
  undo.add([this, members] { take_members(std::move(*members)); });
  undo.keep(slots_, description_, coordinator_);
  const auto slots = slots_;
  slots_.clear();
  std::vector<std::size_t> places;  // index among the old slots; their number if new
  for (const world::BehaviorUse& use : next.behaviors) {
    const std::size_t place = place_of(was.behaviors, use.id, 0);
    const bool is_known = place < slots.size();
    const bool stays = is_known && world::same(was.behaviors[place], use, world::Cost::object) &&
                       was.behaviors[place].inside.empty() == use.inside.empty() &&
                       becoming.keeps(*slots[place], was.behaviors[place], use);
    places.push_back(stays ? place : slots.size());
    if (!stays) {
      slots_.push_back(make_slot(use, becoming.host(), becoming.problems()));
      if (is_known) {
        becoming.note_lost(robot, path + use.id);
      }
      continue;
    }
    slots_.push_back(slots[place]);
    if (const auto& inside = slots[place]->inside) {
      inside->become(inside_of(was.behaviors[place]), inside_of(use), path + use.id + "/",
                     becoming);
    }
  }
  description_ = &next;
  list_slots();
  const bool same_members = slots_ == slots;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i] < slots.size()) {
      members_[i].trace = (*members)[places[i]].trace;
      if (!same_members) {
        members_[i].trace.inhibited_by = -1;
      }
    }
  }
  if (was.coordinator && next.coordinator &&
      becoming.keeps(*coordinator_, *was.coordinator, *next.coordinator)) {
    if (!same_members) {
      becoming.note_other_equipment(*coordinator_);
    }
    return;
  }
  make_coordinator(becoming.host(), becoming.problems());
  if (was.coordinator && next.coordinator) {
    becoming.note_lost(robot, path + next.coordinator->id);
  }
}

void Robot::describe(const world::Robot& next) {
  description_ = &next;
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    sensors_[i]->use = &next.sensors[i];
  }
  if (next.drive) drive_->use = &*next.drive;
  controller_->describe(next);
}

void Robot::become(const world::Robot& was, const world::World& world, std::size_t index,
                   Commons& commons, Becoming& becoming) {
  const world::Robot& next = world.robots[index];
  Undo& undo = becoming.undo();
  std::vector<base::Problem>& problems = becoming.problems();
  const plugin::Call call({.robot = &next.id});
  const bool same_body = world::same_part(world::robot_spec(), "body", &was, &next);
  const bool same_drive = same_body && world::same_part(world::robot_spec(), "drive", &was, &next);
  const bool same_sensors =
      same_body && world::same_part(world::robot_spec(), "sensors", &was, &next);
  // Added first, so it is undone last.
  undo.add([this, again = becoming.begin_robot()] {
    guard_.forgive();
    group_readings();
    trace_.clear();
    for (const auto& equip : *again) {
      equip();
    }
  });
  undo.keep(state_, team_, resource_colours_, asked_, empty_, raised_, logged_);
  undo.keep(description_, body_frame_, drive_, drive_check_, joints_, joint_count_);
  description_ = &next;
  const bool had_charger = team_.charger.has_value();
  const std::vector<Colour> colours = resource_colours_;
  take_membership(world, index, commons);
  // Objects that stay are equipped again if they could see a difference.
  const bool equips_all = !same_drive || !same_sensors || was.team != next.team ||
                          had_charger != team_.charger.has_value() || colours != resource_colours_;
  state_.energy = std::min(state_.energy, state_.capacity);
  become_sensors(was, becoming);
  controller_->become(was, next, "", becoming);
  if (!problems.empty()) return;
  if (same_drive) {
    becoming.describe(*drive_, drive_use());
  } else {
    make_drive(becoming.host(), problems);
  }
  if (!problems.empty()) return;
  trace_.clear();
  group_readings();
  for_each(Order::inner_first, [&](PluginObject& each, const auto&, const auto&) {
    if (each.is_new) {
      blaming(*each.use, problems, [&] { each.equip(*each.held, example()); });
    } else if (each.kind != PluginKind::drive && (equips_all || becoming.has_other(each))) {
      becoming.equip_again(each, example());
      const auto camera = blaming(*each.use, problems, [&] { return each.camera_of(*each.held); });
      if (camera || each.extras().camera) {
        undo.keep(each.own_extras().camera);
        each.own_extras().camera = camera;
      }
    }
  });
  if (!problems.empty()) return;
  check_needs();
  for_each(Order::inner_first,
           [&](PluginObject& each, const std::string& path, const std::string& within) {
             if (each.is_new) {
               blaming(*each.use, problems,
                       [&] { each.reset(becoming.seed(), "robot[" + next.id + "]/" + path); });
               if (each.kind != PluginKind::drive) {
                 becoming.said().ask(each, within, guard_);
               }
             }
           });
  take_live(!same_drive, description_->energy &&
                             (becoming.asks(next, "energy") || description_->energy != was.energy));
}

void Robot::become_sensors(const world::Robot& was, Becoming& becoming) {
  becoming.undo().keep(sensors_);
  const auto slots = sensors_;
  const bool same_body = world::same_part(world::robot_spec(), "body", &was, description_);
  sensors_.clear();
  for (const world::SensorUse& use : description_->sensors) {
    const std::size_t place = place_of(was.sensors, use.id, 0);
    const bool is_known = place < slots.size();
    // The default mounting depends on the body.
    if (is_known && same_body && world::same(was.sensors[place], use, world::Cost::object) &&
        becoming.keeps(*slots[place], was.sensors[place], use)) {
      sensors_.push_back(slots[place]);
      continue;
    }
    SensorSlot& made = *sensors_.emplace_back(std::make_shared<SensorSlot>(use, becoming.host()));
    make_sensor(made, use, becoming.host(), becoming.problems());
    if (is_known) {
      becoming.note_lost(description_->id, use.id);
    }
  }
}

void Robot::take_live(bool has_new_drive, bool has_new_energy) {
  sensor_cost_.reset();
  controller_->take_priorities();
  if (has_new_drive || state_.max_speed_m_s != description_->max_speed) {
    set_max_speed(description_->max_speed);
  }
  state_.coverage_m = description_->coverage;
  state_.is_leader = description_->leader;
  if (has_new_energy) {
    set_energy(*description_->energy);
  }
}

}  // namespace elsie::simulation

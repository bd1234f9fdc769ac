// The parts of robots and controllers that become what an edited world describes.
#include <algorithm>
#include <memory>
#include <string>

#include "elsie/api/remember.h"
#include "elsie/world/parts.h"
#include "elsie/world/same.h"

#include "changes/becoming.h"
#include "plugins/make_plugin.h"
#include "step/controller.h"
#include "step/robot.h"

namespace elsie::simulation {
namespace {

/// The place of the one with this id; that of the end when there is none.
template <class Uses>
std::size_t place_of(const Uses& uses, const std::string& id) {
  const auto at =
      std::find_if(uses.begin(), uses.end(), [&](const auto& use) { return use.id == id; });
  return static_cast<std::size_t>(at - uses.begin());
}

/// Whether values differ that are settled before a run.
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

Memory memory_of(Component& object) {
  Memory memory;
  if (auto* const remembers = dynamic_cast<Remembers*>(&object)) {
    remembers->remember(memory);
  }
  memory.begin_recall();
  return memory;
}

void equip(const TunedObject& object, const std::optional<Setup>& setup, Memory memory,
           const Perception& example) {
  if (setup) {
    plugin::apply_parameters(*object.declaration, *object.object, setup->parameters,
                             setup->elements);
  }
  Tuning::equip(object, *object.object, example);
  if (auto* const remembers = dynamic_cast<Remembers*>(object.object)) {
    remembers->remember(memory);
  }
}

/// Puts a pointer to what is owned aside until the edit is settled.
template <class Owner>
void set_aside(Undo& undo, Owner& owner) {
  auto before = std::make_shared<Owner>(std::move(owner));
  owner = {};
  undo.add([&owner, before] { owner = std::move(*before); });
}

}  // namespace

bool Becoming::keeps(Component& object, const Declaration& declaration, const world::PluginUse& use,
                     const world::PluginUse& was, const world::PluginUse& next) {
  if (world::same(was, next)) {
    return true;
  }
  if (!asked_uses_.contains(&use) || was.plugin != next.plugin || was.id != next.id ||
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
  tuned_[&object] = {Tuning::complete(before, now, declaration),
                     Tuning::complete(now, before, declaration)};
  return true;
}

void Becoming::equip_again(const std::function<TunedObject()>& find, const Perception& example) {
  const TunedObject object = find();
  std::optional<Setup> before, now;
  if (const auto tuned = tuned_.find(object.object); tuned != tuned_.end()) {
    before = tuned->second.before;
    now = tuned->second.now;
  }
  blaming(*object.use, problems_, [&] {
    if (now) {
      Tuning::try_out(object, *now, example);
    }
    const Memory memory = memory_of(*object.object);
    again_->push_back([find, before, memory, example] {
      const TunedObject restored = find();
      std::vector<base::Problem> ignored;
      blaming(*restored.use, ignored, [&] { equip(restored, before, memory, example); });
    });
    equip(object, now, memory, example);
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

/// Members stay where they are as long as there are as many.
void Controller::take_members(std::vector<Member> members) {
  if (members.size() == members_.size()) {
    std::move(members.begin(), members.end(), members_.begin());
  } else {
    members_ = std::move(members);
  }
}

void Controller::become(const world::Coordination& was, const world::Coordination& next,
                        const std::string& path, Becoming& becoming) {
  Undo& undo = becoming.undo();
  const std::string& robot = setting_.guard.robot();
  // Before the slots that they are of: undone after them.
  const auto members = std::make_shared<std::vector<Member>>(copied_members());
  undo.add([this, members, reasons = reasons_] {
    take_members(std::move(*members));
    reasons_ = reasons;
  });
  undo.keep(slots_);
  undo.keep(description_);
  const auto slots = slots_;
  const auto reasons = reasons_;
  slots_.clear();
  std::vector<std::size_t> places;  // among those before; or their number
  for (const world::BehaviorUse& use : next.behaviors) {
    const std::size_t place = place_of(was.behaviors, use.id);
    const bool is_known = place < slots.size();
    const bool stays = is_known && world::same(was.behaviors[place], use, world::Cost::object) &&
                       was.behaviors[place].inside.empty() == use.inside.empty() &&
                       becoming.keeps(*slots[place]->object, *slots[place]->declaration,
                                      *slots[place]->use, was.behaviors[place], use);
    places.push_back(stays ? place : slots.size());
    if (!stays) {
      slots_.push_back(make_slot(use, becoming.host(), becoming.problems()));
      becoming.note_new(slots_.back()->object.get(), robot, path + use.id, is_known);
      continue;
    }
    const std::shared_ptr<Slot>& slot = slots_.emplace_back(slots[place]);
    undo.keep(slot->use);
    slot->use = &use;
    if (slot->inside) {
      slot->inside->become(inside_of(was.behaviors[place]), inside_of(use), path + use.id + "/",
                           becoming);
    }
  }
  const world::Coordination* const before = std::exchange(description_, &next);
  list_slots();
  const bool same_members = slots_ == slots;
  undo.keep(has_other_members_);
  has_other_members_ = !same_members;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i] < slots.size()) {
      members_[i].trace = (*members)[places[i]].trace;
      if (!same_members) {
        members_[i].trace.inhibited_by = -1;
      }
      reasons_[i] = reasons[places[i]];
    }
  }
  const bool keeps = was.coordinator && next.coordinator
                         ? becoming.keeps(*coordinator_, *coordinator_declaration_,
                                          *before->coordinator, *was.coordinator, *next.coordinator)
                         : !was.coordinator && !next.coordinator;
  if (!keeps) {
    undo.keep(coordinator_declaration_);
    undo.keep(random_);
    set_aside(undo, coordinator_);
    coordinator_declaration_ = nullptr;
    make_coordinator(becoming.host(), becoming.problems());
    if (coordinator_) {
      becoming.note_new(coordinator_.get(), robot, path + next.coordinator->id,
                        was.coordinator.has_value());
    }
  }
}

void Controller::equip_anew(Becoming& becoming, const Perception& example, bool all) {
  for (const auto& slot : slots_) {
    if (becoming.is_new(slot->object.get())) {
      if (slot->inside) {
        slot->inside->equip(example, becoming.problems());
      }
      blaming(*slot->use, becoming.problems(), [&] { slot->object->equipped(example); });
      continue;
    }
    if (slot->inside) {
      slot->inside->equip_anew(becoming, example, all);
    }
    if (all || becoming.is_tuned(slot->object.get())) {
      becoming.equip_again([slot] { return slot->own_object(); }, example);
    }
  }
  if (coordinator_ && becoming.is_new(coordinator_.get())) {
    blaming(*description_->coordinator, becoming.problems(),
            [&] { coordinator_->equipped(members_, example); });
  } else if (coordinator_ && (all || has_other_members_ || becoming.is_tuned(coordinator_.get()))) {
    becoming.equip_again([this] { return own_object(); }, example);
  }
  has_other_members_ = false;
}

void Controller::reset_new(Becoming& becoming, const std::string& path, const std::string& shown) {
  for (const auto& each : slots_) {
    Slot& slot = *each;
    const std::string name = path + "behavior[" + slot.use->id + "]";
    if (!becoming.is_new(slot.object.get())) {
      if (slot.inside) {
        slot.inside->reset_new(becoming, name + "/", shown + slot.use->id + "/");
      }
      continue;
    }
    slot.random = Random(becoming.seed(), name);
    slot.response = {};
    if (slot.inside) {
      slot.inside->reset(becoming.seed(), name + "/");
      slot.inside->ask(shown + slot.use->id + "/", becoming.said());
    }
    blaming(*slot.use, becoming.problems(), [&] { slot.object->reset(slot.random); });
    becoming.said().ask(*slot.object, *slot.use, shown, setting_.guard);
  }
  if (coordinator_ && becoming.is_new(coordinator_.get())) {
    random_ = Random(becoming.seed(), path + "coordinator");
    blaming(*description_->coordinator, becoming.problems(), [&] { coordinator_->reset(random_); });
    becoming.said().ask(*coordinator_, *description_->coordinator, shown, setting_.guard);
  }
}

void Robot::become(const world::Robot& was, const world::Robot& next, const Membership& membership,
                   Becoming& becoming) {
  Undo& undo = becoming.undo();
  std::vector<base::Problem>& problems = becoming.problems();
  const plugin::Call call({.robot = next.id.c_str()});
  const bool same_body = world::same_part(world::robot_spec(), "body", &was, &next);
  const bool same_drive = same_body && world::same_part(world::robot_spec(), "drive", &was, &next);
  const bool same_sensors =
      same_body && world::same_part(world::robot_spec(), "sensors", &was, &next);
  const bool same_team = was.team == next.team &&
                         membership.charger.has_value() == team_.charger.has_value() &&
                         membership.resource_colours == resource_colours_;
  // What stays is equipped anew where it may see a difference. That is undone last of all.
  const bool equips_all = !same_drive || !same_sensors || !same_team;
  undo.add([this, again = becoming.begin_robot()] {
    guard_.forgive();
    regroup();
    trace_.clear();
    controller_->list_members("", 0, -1, trace_);
    for (const auto& equip : *again) {
      equip();
    }
  });
  undo.add([this, state = state_, team = team_, colours = resource_colours_, asked = asked_,
            cost = sensor_cost_, empty = empty_, raised = raised_, logged = logged_] {
    state_ = state;
    team_ = team;
    resource_colours_ = colours;
    asked_ = asked;
    sensor_cost_ = cost;
    empty_ = empty;
    raised_ = raised;
    logged_ = logged;
  });
  undo.keep(description_);
  undo.keep(tuning_);
  undo.keep(body_frame_);
  undo.keep(joints_);
  undo.keep(wanted_joints_);
  undo.keep(drive_check_);
  description_ = &next;
  tuning_.settle();
  guard_.forget(undo);
  take_membership(membership);
  state_.energy = std::min(state_.energy, state_.capacity);
  drive_use_.location = next.location;
  become_sensors(was, becoming);
  controller_->become(was, next, "", becoming);
  if (!problems.empty()) {
    return;
  }
  if (!same_drive) {
    become_drive(becoming);
  }
  if (!problems.empty()) {
    return;
  }
  trace_.clear();
  controller_->list_members("", 0, -1, trace_);
  regroup();
  for (const auto& slot : sensors_) {
    if (becoming.is_new(slot->object.get())) {
      blaming(*slot->use, problems, [&] {
        slot->object->equipped({&slot->mounting, resource_colours_});
      });
    } else if (equips_all || becoming.is_tuned(slot->object.get())) {
      undo.keep(slot->camera);
      becoming.equip_again([this, slot] { return own_object(*slot); }, example());
      slot->camera = blaming(*slot->use, problems, [&] { return slot->object->camera(); });
    }
  }
  controller_->equip_anew(becoming, example(), equips_all);
  if (!problems.empty()) {
    return;
  }
  controller_->check_needs(groups_, next.id, "");
  const std::string path = "robot[" + next.id + "]/";
  for (const auto& slot : sensors_) {
    if (becoming.is_new(slot->object.get())) {
      slot->random = Random(becoming.seed(), path + "sensor[" + slot->use->id + "]");
      slot->object->forget();
      blaming(*slot->use, problems, [&] { slot->object->reset(slot->random); });
      becoming.said().ask(*slot->object, *slot->use, "", guard_);
    }
  }
  controller_->reset_new(becoming, path, "");
  if (!same_drive) {
    drive_random_ = Random(becoming.seed(), path + "drive");
    blaming(drive_use(), problems, [&] { drive_->reset(drive_random_); });
  }
  take_live(!same_drive, description_->energy &&
                             (becoming.asks(next, "energy") || description_->energy != was.energy));
}

void Robot::become_sensors(const world::Robot& was, Becoming& becoming) {
  Undo& undo = becoming.undo();
  undo.keep(sensors_);
  const auto slots = sensors_;
  const bool same_body = world::same_part(world::robot_spec(), "body", &was, description_);
  sensors_.clear();
  for (const world::SensorUse& use : description_->sensors) {
    const std::size_t place = place_of(was.sensors, use.id);
    const bool is_known = place < slots.size();
    // Where it is mounted follows from the body, by default.
    if (!is_known || !same_body || !world::same(was.sensors[place], use, world::Cost::object) ||
        !becoming.keeps(*slots[place]->object, *slots[place]->declaration, *slots[place]->use,
                        was.sensors[place], use)) {
      sensors_.push_back(make_sensor(use, becoming.host(), becoming.problems()));
      becoming.note_new(sensors_.back()->object.get(), description_->id, use.id, is_known);
      continue;
    }
    const std::shared_ptr<SensorSlot>& slot = sensors_.emplace_back(slots[place]);
    undo.keep(slot->use);
    undo.keep(slot->energy_cost);
    slot->use = &use;
    slot->energy_cost = use.energy_cost;
  }
  sum_costs();
}

void Robot::become_drive(Becoming& becoming) {
  Undo& undo = becoming.undo();
  undo.keep(drive_declaration_);
  undo.keep(drive_random_);
  undo.keep(drive_use_);
  set_aside(undo, drive_);
  make_drive(becoming.host(), becoming.problems());
}

/// What may be changed in place.
void Robot::take_live(bool has_new_drive, bool has_new_energy) {
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

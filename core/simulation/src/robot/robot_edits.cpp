// A robot becomes what an edited world describes.
#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "elsie/base/number_text.h"
#include "elsie/world/same.h"

#include "edits/transaction.h"
#include "robot/common_data.h"
#include "robot/robot.h"

namespace elsie::simulation {

void Robot::describe(const world::Robot& next) {
  description_ = &next;
  for (std::size_t i = 0; i < sensors_.size(); ++i) sensors_[i]->use = &next.sensors[i];
  for (std::size_t i = 0; i < actuators_.size(); ++i) {
    actuators_[i]->use = &next.actuators[i];
  }
  if (next.drive) drive_->use = &*next.drive;
  if (next.localisation) localisation_->use = &*next.localisation;
  controller_->describe(next);
}

void Robot::become(const world::Robot& was, const world::World& world, std::size_t index,
                   CommonData& common, EditTransaction& transaction) {
  const world::Robot& next = world.robots[index];
  Undo& undo = transaction.undo();
  std::vector<base::Problem>& problems = transaction.problems();
  const plugin::Call call({.robot = &next.id});
  const bool same_body = world::same_part(world::robot_spec(), "body", &was, &next);
  const bool same_drive = same_body && world::same_part(world::robot_spec(), "drive", &was, &next);
  const bool same_mounted = same_body &&
                            world::same_part(world::robot_spec(), "segments", &was, &next) &&
                            world::same_part(world::robot_spec(), "sensors", &was, &next) &&
                            world::same_part(world::robot_spec(), "actuators", &was, &next);
  // Added first, so it is undone last.
  undo.add([this] {
    guard_.forgive();
    group_readings();
    trace_.clear();
  });
  undo.keep(state_, team_, resource_colours_, asked_, empty_, raised_, logged_);
  undo.keep(description_, body_frame_, truth_, drive_, drive_check_, joints_, joint_count_);
  undo.keep(localisation_, localiser_, segments_, vehicles_);
  description_ = &next;
  seed_ = transaction.seed();
  const LocalisationSlot* const had_localisation = localiser_;
  const bool had_charger = team_.charger.has_value();
  const std::vector<Colour> colours = resource_colours_;
  take_membership(world, index, common);
  // Objects that stay are equipped again if they could see a difference.
  const bool equips_all = !same_drive || !same_mounted || was.team != next.team ||
                          had_charger != team_.charger.has_value() || colours != resource_colours_;
  state_.energy = std::min(state_.energy, state_.capacity);
  become_mounted(sensors_, was, &world::Robot::sensors, transaction);
  become_mounted(actuators_, was, &world::Robot::actuators, transaction);
  controller_->become(was, next, "", transaction);
  if (!problems.empty()) return;
  if (same_drive) {
    transaction.describe(*drive_, drive_use());
  } else {
    make_drive(transaction.host(), problems);
  }
  become_localised(was, transaction);
  if (!problems.empty()) return;
  trace_.clear();
  group_readings();
  for_each(Order::inner_first, [&](PluginObject& each, const auto&, const auto&) {
    if (each.is_new) {
      blaming(*each.use, problems, [&] { each.equip(*each.held, example()); });
    } else if (each.kind != PluginKind::drive && (equips_all || transaction.has_other(each))) {
      transaction.equip_again(each, example());
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
                       [&] { each.reset(transaction.seed(), "robot[" + next.id + "]/" + path); });
               if (each.kind != PluginKind::drive) {
                 transaction.said().ask(each, within, guard_);
               }
             }
           });
  if (!localiser_) {
    state_.pose = truth_.pose;
    state_.moving = truth_.moving;
  } else if (had_localisation != localiser_) {
    blaming(*localiser_->use, problems, [&] {
      believe(guard_.run(*localiser_->use,
                         [&] { return localiser_->object().start(truth_, localiser_->random); }));
    });
  }
  take_live(!same_drive, description_->energy && (transaction.asks(next, "energy") ||
                                                  description_->energy != was.energy));
}

void Robot::become_localised(const world::Robot& was, EditTransaction& transaction) {
  const auto& next = description_->localisation;
  if (was.localisation && next && transaction.keeps(*localisation_, *was.localisation, *next)) {
    return;
  }
  make_localisation(transaction.host(), transaction.problems());
}

template <class Slot>
void Robot::become_mounted(std::vector<std::shared_ptr<Slot>>& all, const world::Robot& was,
                           const std::vector<world::MountedUse> world::Robot::*uses,
                           EditTransaction& transaction) {
  transaction.undo().keep(all);
  const auto slots = all;
  const bool same_body = world::same_part(world::robot_spec(), "body", &was, description_);
  const bool same_segments = world::same_part(world::robot_spec(), "segments", &was, description_);
  all.clear();
  for (const world::MountedUse& use : description_->*uses) {
    const std::size_t former = index_of(was.*uses, use.id, 0);
    const bool is_known = former < slots.size();
    // The default mounting depends on what it is mounted on.
    if (is_known && (use.segment.empty() ? same_body : same_segments) &&
        world::same((was.*uses)[former], use, world::Cost::object) &&
        transaction.keeps(*slots[former], (was.*uses)[former], use)) {
      all.push_back(slots[former]);
      continue;
    }
    Slot& made = *all.emplace_back(std::make_shared<Slot>(use, transaction.host(), *this));
    make_mounted(made, use, transaction.host(), transaction.problems());
    if (is_known) {
      transaction.note_lost(description_->id, use.id);
    }
  }
}

void Robot::set_priority(std::size_t behavior, double priority) {
  std::size_t index = behavior;
  if (!std::isfinite(priority) || !controller_->set_priority(index, priority)) {
    throw std::invalid_argument(
        "the priority " + base::number_text(priority) + " of behaviour " +
        std::to_string(behavior) + " of the robot '" + description_->id +
        "' cannot be set; expected a finite number, and one of its behaviours");
  }
}

void Robot::take_live(bool has_new_drive, bool has_new_energy) {
  mounted_cost_.reset();
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

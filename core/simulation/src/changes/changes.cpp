#include "changes/changes.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "elsie/world/footprint.h"

#include "changes/room.h"

namespace elsie::simulation {
namespace {

std::string number(double value) { return world::text_of(value); }

[[noreturn]] void refuse(const std::string& change, const std::string& problem) {
  throw ChangeRefused(change + ": " + problem);
}

/// What a plugin said while it was asked.
std::string said(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "it threw something that is no std::exception";
  }
}

bool is_of_pose(const std::string& attribute) {
  return attribute == "x" || attribute == "y" || attribute == "z" || attribute == "heading_deg";
}

/// The entry that `is` finds, or a new one.
template <class Entry, class Is>
Entry& entry(std::vector<Entry>& list, Is is) {
  const auto known = std::find_if(list.begin(), list.end(), is);
  return known == list.end() ? list.emplace_back() : *known;
}

void add_text(std::string& list, const std::string& text) {
  list += (list.empty() ? "" : ", ") + text;
}

}  // namespace

ChangeRefused ChangeRefused::at(double time_s) const {
  return ChangeRefused("at " + number(time_s) + " s, " + what());
}

std::vector<DueChanges> by_step(std::span<const TimedChange> changes, double step_s, double end_s) {
  constexpr double kRounding = 1e-6;  // of a step: 0.57 is not a little after 57 steps of 0.01
  std::vector<DueChanges> schedule;
  for (const TimedChange& timed : changes) {
    const std::string text = timed.change.path + "=" + timed.change.value;
    if (!(timed.time_s >= 0.0 && timed.time_s < end_s)) {
      refuse(text, "its time is " + number(timed.time_s) +
                       " s, but the run begins at 0 and ends after " + number(end_s) +
                       " s at the latest; expected a time in between");
    }
    const auto step =
        static_cast<std::uint64_t>(std::max(0.0, std::ceil(timed.time_s / step_s - kRounding)));
    auto at = std::upper_bound(
        schedule.begin(), schedule.end(), step,
        [](std::uint64_t asked, const DueChanges& due) { return asked < due.step; });
    if (at == schedule.begin() || std::prev(at)->step != step) {
      at = std::next(schedule.insert(at, {step, timed.time_s, {}}));
    }
    std::prev(at)->changes.push_back(timed.change);
  }
  return schedule;
}

Changes::Changes(const world::World& world, const plugin::Host& host,
                 std::vector<std::string> data_directories)
    : world_(world), attributes_(world, host, std::move(data_directories)) {}

void Changes::make(std::span<const Change> changes, const Stage& stage,
                   std::vector<EventRecord>& events) const {
  const Plan plan = this->plan(changes, stage, {});
  check_room(plan, stage);
  set_up(plan, stage);
  // From here on nothing is refused.
  for (const Item& item : plan.items) {
    Robot& robot = *stage.robots[item.robot];
    const std::string& name = item.place.field.name;
    if (item.place.is_parameter) {
      // set_up() has seen to it.
    } else if (name == "max_speed") {
      robot.set_max_speed(std::get<double>(item.value));
    } else if (name == "coverage") {
      robot.set_coverage(std::get<double>(item.value));
    } else if (name == "leader") {
      robot.set_leader(std::get<bool>(item.value));
    } else if (name == "energy") {
      robot.set_energy(std::get<double>(item.value));
    } else if (name == "energy_cost") {
      robot.set_energy_cost(*item.place.use, std::get<double>(item.value));
    } else if (name == "priority") {
      robot.set_priority(*item.place.use, std::get<double>(item.value));
    }
    events.push_back({stage.time_s, item.place.robot->id, "changed", item.text});
  }
  for (const Placed& placed : plan.placed) {
    stage.engine.place_robot(placed.robot, placed.pose, placed.z);
    stage.robots[placed.robot]->set_body(stage.engine.robot(placed.robot));
  }
}

void Changes::check(std::span<const DueChanges> schedule, const Stage& stage) const {
  Setups setups;
  for (const DueChanges& due : schedule) {
    try {
      for (Tuned& tuned : plan(due.changes, stage, setups).tuned) {
        setups[tuned.use] = std::move(tuned.setup);
      }
    } catch (const ChangeRefused& refused) {
      throw refused.at(due.time_s);
    }
  }
}

/// What a change means: an item for each attribute that its path leads to.
void Changes::resolve(const Change& change, std::vector<Item>& items) const {
  const std::string asked = change.path + "=" + change.value;
  try {
    for (world::AttributePlace& place : attributes_.find(change.path)) {
      if (!place.field.live) {
        std::string others;
        for (const std::string& name : place.live) {
          add_text(others, name);
        }
        refuse(asked, "'" + place.field.name + "' of <" + place.element +
                          "> is settled before a run and stays as it is while it goes on" +
                          (others.empty() ? "" : "; what may change is " + others));
      }
      Item item;
      item.value = attributes_.read(place, change.value);
      item.text = place.path + "=" + change.value;
      item.robot = static_cast<std::size_t>(place.robot - world_.robots.data());
      item.place = std::move(place);
      check_value(item);
      items.push_back(std::move(item));
    }
  } catch (const ChangeRefused&) {
    throw;
  } catch (const std::invalid_argument& problem) {
    refuse(asked, problem.what());
  }
}

/// What the range of an attribute does not say.
void Changes::check_value(const Item& item) const {
  if (item.place.is_parameter || item.place.use) {
    return;
  }
  const std::string& name = item.place.field.name;
  const world::Robot& robot = world_.robots[item.robot];
  if (name == "energy" && std::get<double>(item.value) > robot.battery) {
    refuse(item.text, "the battery of the robot '" + robot.id + "' holds " + number(robot.battery) +
                          " units; expected no more than that");
  }
  const double reach = name == "x"   ? 0.5 * world_.arena.length
                       : name == "y" ? 0.5 * world_.arena.width
                                     : 0.0;
  if (reach > 0.0 && std::abs(std::get<double>(item.value)) > reach) {
    refuse(item.text, "that is outside of the arena, which reaches from " + number(-reach) +
                          " to " + number(reach) + " in " + name);
  }
}

Changes::Plan Changes::plan(std::span<const Change> changes, const Stage& stage,
                            const Setups& setups) const {
  Plan plan;
  for (const Change& change : changes) {
    resolve(change, plan.items);
  }
  for (const Item& item : plan.items) {
    const std::string& name = item.place.field.name;
    const Robot& robot = *stage.robots[item.robot];
    if (item.place.is_parameter) {
      const world::PluginUse* use = item.place.use;
      Tuned& tuned = entry(plan.tuned, [&](const Tuned& other) { return other.use == use; });
      if (!tuned.use) {
        const auto known = setups.find(use);
        tuned = {item.robot, use, known == setups.end() ? robot.setup(*use) : known->second, ""};
      }
      (item.place.nested ? tuned.setup.elements[*item.place.nested].parameters
                         : tuned.setup.parameters)[name] = item.value;
      add_text(tuned.text, item.text);
    } else if (!item.place.use && is_of_pose(name)) {
      Placed& placed = entry(plan.placed, [&](const Placed& other) {
        return other.robot == item.robot && !other.text.empty();
      });
      if (placed.text.empty()) {
        placed = {item.robot, robot.state().pose, height(stage.engine.robot(item.robot).frame), ""};
      }
      const double value = std::get<double>(item.value);
      (name == "x"   ? placed.pose.x
       : name == "y" ? placed.pose.y
       : name == "z" ? placed.z
                     : placed.pose.heading_rad) =
          name == "heading_deg" ? wrap_angle(radians(value)) : value;
      add_text(placed.text, item.text);
    }
  }
  for (const Tuned& tuned : plan.tuned) {
    check_tuned(tuned, stage);
  }
  return plan;
}

void Changes::check_tuned(const Tuned& tuned, const Stage& stage) const {
  Robot& robot = *stage.robots[tuned.robot];
  std::optional<Camera> camera;
  try {
    camera = robot.try_out(*tuned.use, tuned.setup);
  } catch (...) {
    refuse(tuned.text, said(std::current_exception()));
  }
  for (std::size_t i = 0; i < robot.sensor_count(); ++i) {
    if (&stage.robots[tuned.robot]->description().sensors[i] != tuned.use) {
      continue;
    }
    if (camera.has_value() != robot.camera(i).has_value()) {
      refuse(tuned.text, "the sensor would " + std::string(camera ? "begin" : "cease") +
                             " to look through a camera; whether it does is settled before a run");
    }
    if (const auto problem = camera ? stage.cameras.problem_of(*camera) : std::nullopt) {
      refuse(tuned.text, *problem);
    }
  }
}

void Changes::check_room(const Plan& plan, const Stage& stage) const {
  if (plan.placed.empty()) {
    return;
  }
  Room room(world_, stage.robots, stage.engine);
  for (const Placed& placed : plan.placed) {
    room.place(placed.robot, placed.pose, placed.z);
  }
  for (const Placed& placed : plan.placed) {
    if (const auto problem = room.problem_of(placed.robot)) {
      refuse(placed.text, *problem + "; expected a free place in the arena");
    }
  }
}

/// All of them or none.
void Changes::set_up(const Plan& plan, const Stage& stage) const {
  std::vector<Setup> before;
  for (const Tuned& tuned : plan.tuned) {
    before.push_back(stage.robots[tuned.robot]->setup(*tuned.use));
  }
  for (std::size_t i = 0; i < plan.tuned.size(); ++i) {
    const Tuned& tuned = plan.tuned[i];
    try {
      stage.robots[tuned.robot]->set_up(*tuned.use, tuned.setup);
    } catch (const PluginFault&) {
      throw;
    } catch (...) {
      const std::exception_ptr thrown = std::current_exception();
      while (i-- > 0) {
        stage.robots[plan.tuned[i].robot]->set_up(*plan.tuned[i].use, before[i]);
      }
      refuse(tuned.text, said(thrown));
    }
  }
}

}  // namespace elsie::simulation

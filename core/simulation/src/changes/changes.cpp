#include "changes/changes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "elsie/base/number_text.h"
#include "elsie/world/footprint.h"

#include "changes/room.h"
#include "plugins/guard.h"

namespace elsie::simulation {
namespace {

std::string number(double value) { return base::number_text(value); }

[[noreturn]] void refuse(const std::string& change, const std::string& problem) {
  throw ChangeRefused(change + ": " + problem);
}

bool edits_element(const Change& change) {
  return change.value.starts_with('<') || change.path.ends_with("@remove") ||
         change.path.find("[+") != std::string::npos;
}

void add_text(std::string& list, const std::string& text) {
  list += (list.empty() ? "" : ", ") + text;
}

std::string file_and_line(const base::Location& where) {
  return where.line > 0 ? where.file.text() + ":" + std::to_string(where.line)
                        : "the world's <changes>";
}

/// New parameters of a plugin object.
struct Tuned {
  Robot* robot = nullptr;
  PluginObject* object = nullptr;
  Setup setup;
  std::string text;
};
using Setups = std::map<const PluginObject*, Setup>;

/// Plans changes that are made together, one attribute of a robot at a time, without changing the
/// robot.
class Plan {
 public:
  /// `setups`: parameters that earlier changes of the schedule will have set.
  Plan(const world::World& world, const Changes::Stage& stage, const Setups& setups)
      : world_(world), stage_(stage), setups_(setups) {}

  /// Plans the next attribute; `text` is for messages: "robot[r1]/@x=3".
  void set(const world::AttributePlace& place, const ParameterValue& value, std::string text) {
    index_ = place.robot_index;
    text_ = std::move(text);
    const std::string& name = place.field.name;
    if (!place.attribute) {
      set_parameter(place, value);
    } else if (name == "x") {
      placed().pose.x = checked_place(name, std::get<double>(value), 0.5 * world_.arena.length);
    } else if (name == "y") {
      placed().pose.y = checked_place(name, std::get<double>(value), 0.5 * world_.arena.width);
    } else if (name == "z") {
      const double metres = std::get<double>(value);
      if (const auto fault = stage_.engine.fault_of_height(metres)) refuse(text_, *fault);
      placed().z = metres;
    } else if (name == "heading_deg") {
      placed().pose.heading_rad = wrap_angle(radians(std::get<double>(value)));
    } else if (name == "energy") {
      check_energy(std::get<double>(value));
    }  // of the others, any value can be taken
  }

  std::vector<EventRecord> events;
  std::vector<Tuned> tunings;
  std::vector<Changes::Placed> places;

 private:
  void set_parameter(const world::AttributePlace& place, const ParameterValue& value) {
    PluginObject* const object = robot().find_object(*place.use);
    auto tuned = std::find_if(tunings.begin(), tunings.end(),
                              [&](const Tuned& other) { return other.object == object; });
    if (tuned == tunings.end()) {
      const auto known = setups_.find(object);
      tuned = tunings.insert(
          tuned, {&robot(), object, known == setups_.end() ? object->setup() : known->second, ""});
    }
    (place.nested ? tuned->setup.elements[*place.nested].parameters
                  : tuned->setup.parameters)[place.field.name] = value;
    add_text(tuned->text, text_);
  }

  Robot& robot() const { return *stage_.robots[index_]; }
  double checked_place(const std::string& axis, double place, double reach) const {
    if (std::abs(place) > reach) {
      refuse(text_, "that is outside of the arena, which reaches from " + number(-reach) + " to " +
                        number(reach) + " in " + axis);
    }
    return place;
  }
  void check_energy(double units) const {
    const world::Robot& described = robot().description();
    if (units > described.battery) {
      refuse(text_, "the battery of the robot '" + described.id + "' holds " +
                        number(described.battery) + " units; expected no more than that");
    }
  }
  Changes::Placed& placed() {
    auto placed = std::find_if(places.begin(), places.end(),
                               [&](const auto& other) { return other.robot == index_; });
    if (placed == places.end()) {
      placed = places.insert(
          placed, {index_, robot().state().pose, height(stage_.engine.robot(index_).frame), ""});
    }
    add_text(placed->text, text_);
    return *placed;
  }

  const world::World& world_;
  const Changes::Stage& stage_;
  const Setups& setups_;
  std::size_t index_ = 0;
  std::string text_;
};

void check_tuned(const Tuned& tuned, const Cameras& cameras) {
  std::optional<Camera> camera;
  try {
    camera = tuned.robot->try_out(*tuned.object, tuned.setup);
  } catch (...) {
    refuse(tuned.text, thrown::what_was_thrown());
  }
  if (camera.has_value() != tuned.object->extras().camera.has_value()) {
    refuse(tuned.text, "the sensor would " + std::string(camera ? "gain" : "lose") +
                           " a camera; replace the whole element instead");
  }
  if (const auto problem = camera ? cameras.problem_of(*camera) : std::nullopt) {
    refuse(tuned.text, *problem);
  }
}

Plan plan_of(std::span<const Change> changes, const world::World& world,
             const world::Attributes& attributes, const Changes::Stage& stage,
             const Setups& setups) {
  Plan plan(world, stage, setups);
  for (const Change& change : changes) {
    try {
      for (const world::AttributePlace& place : attributes.find(change.path)) {
        const ParameterValue value = attributes.read(place, change.value);
        const auto event = events::Changed::of(place.path, change.value);
        plan.set(place, value, event.detail());
        plan.events.push_back({stage.time_s, place.robot->id, event});
      }
    } catch (const ChangeRefused&) {
      throw;
    } catch (const std::invalid_argument& problem) {
      refuse(change.text(), problem.what());
    }
  }
  for (const Tuned& tuned : plan.tunings) {
    check_tuned(tuned, stage.cameras);
  }
  return plan;
}

void check_room(const std::vector<Changes::Placed>& places, const world::World& world,
                const physics::Engine& engine) {
  if (places.empty()) return;
  Room room(world, engine);
  for (const Changes::Placed& placed : places) {
    room.place(placed.robot, placed.pose, placed.z);
  }
  for (const Changes::Placed& placed : places) {
    if (const auto problem = room.problem_of(placed.robot)) {
      refuse(placed.text, *problem + "; expected a free place in the arena");
    }
  }
}

/// Sets all parameters or none.
void set_up(const std::vector<Tuned>& tunings) {
  Undo undo;
  for (const Tuned& tuned : tunings) {
    try {
      const Setup before = tuned.object->completed(tuned.object->setup(), tuned.setup);
      tuned.robot->set_up(*tuned.object, tuned.setup);
      undo.add([&tuned, before] { tuned.robot->set_up(*tuned.object, before); });
    } catch (const PluginFault&) {
      throw;
    } catch (...) {
      refuse(tuned.text, thrown::what_was_thrown());
    }
  }
  undo.settle();
}

}  // namespace

ChangeRefused ChangeRefused::at(double time_s, std::string from) const {
  ChangeRefused refused("at " + number(time_s) + " s, " + what());
  refused.from_ = std::move(from);
  return refused;
}

std::string ChangeRefused::report() const {
  std::string text = (from_.empty() ? "--at" : from_) + ": " + what();
  for (const ChangeRefused& other : others_) {
    text += '\n' + other.report();
  }
  return text;
}

void ChangeRefused::raise(std::vector<ChangeRefused> refused) {
  if (!refused.empty()) {
    ChangeRefused first = std::move(refused.front());
    refused.erase(refused.begin());
    first.others_ = std::move(refused);
    throw first;
  }
}

bool DueChanges::come_before(double end_s, double step_s) const {
  const double begins = std::ceil(time_s / step_s - kRounding);  // steps
  return time_s >= 0.0 && time_s < end_s && begins < end_s / step_s - kRounding;
}

TimedChange timed(const world::TimedEdit& edit) {
  return {edit.time,
          {edit.path, edit.element ? *edit.element : edit.value.value_or("")},
          file_and_line(edit.location)};
}

std::vector<TimedChange> with_own(const world::World& world, std::span<const TimedChange> changes) {
  std::vector<TimedChange> all;
  for (const world::TimedEdit& edit : world.changes) {
    all.push_back(timed(edit));
  }
  all.insert(all.end(), changes.begin(), changes.end());
  return all;
}

std::vector<TimedChange> still_to_come(const world::World& world,
                                       std::span<const TimedChange> changes, double after_s) {
  std::vector<TimedChange> rest = with_own(world, changes);
  std::erase_if(rest, [&](const TimedChange& one) {
    return DueChanges{one.time_s, {}}.are_due(after_s, world.physics.step);
  });
  return rest;
}

std::vector<DueChanges> by_time(std::span<const TimedChange> changes) {
  std::map<double, DueChanges> schedule;
  for (const TimedChange& timed : changes) {
    DueChanges& due = schedule[timed.time_s];
    due.time_s = timed.time_s;
    due.changes.push_back(timed.change);
    std::string& first = timed.from.empty() ? due.given : due.from;
    if (first.empty()) first = timed.from.empty() ? timed.change.text() : timed.from;
  }
  std::vector<DueChanges> all;
  for (auto& [time_s, due] : schedule) {
    all.push_back(std::move(due));
  }
  return all;
}

Changes::Changes(const world::World& world, const plugin::Host& host, const Options& options)
    : world_(world), attributes_(world, host, options.data_directories, options.files) {}

void Changes::describe(std::span<const Change> changes) const {
  for (const Change& change : changes) {
    for (const world::AttributePlace& place : places(change)) {
      attributes_.set(place, change.value);
    }
  }
}

bool Changes::is_live(const Change& change) const {
  const auto places = this->places(change);
  return !edits_element(change) &&
         std::all_of(places.begin(), places.end(),
                     [](const world::AttributePlace& place) { return place.field.is_live(); });
}

std::vector<world::AttributePlace> Changes::places(const Change& change) const {
  try {
    return edits_element(change) ? std::vector<world::AttributePlace>()
                                 : attributes_.find(change.path);
  } catch (const std::invalid_argument&) {
    return {};  // make() reports the error
  }
}

std::vector<Changes::Placed> Changes::make(std::span<const Change> changes, const Stage& stage,
                                           std::vector<EventRecord>& events) const {
  const Setups none;
  Plan plan = plan_of(changes, world_, attributes_, stage, none);
  check_room(plan.places, world_, stage.engine);
  set_up(plan.tunings);
  events.insert(events.end(), plan.events.begin(), plan.events.end());
  return std::move(plan.places);
}

std::vector<ChangeRefused> Changes::refused(std::span<const DueChanges> schedule,
                                            const Stage& stage) const {
  std::vector<ChangeRefused> all;
  Setups setups;
  for (const DueChanges& due : schedule) {
    try {
      for (Tuned& tuned : plan_of(due.changes, world_, attributes_, stage, setups).tunings) {
        setups[tuned.object] = std::move(tuned.setup);
      }
    } catch (const ChangeRefused& refused) {
      all.push_back(refused.at(due.time_s, due.from));
    }
  }
  return all;
}

}  // namespace elsie::simulation

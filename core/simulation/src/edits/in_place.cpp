#include "edits/in_place.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "elsie/base/number_text.h"
#include "elsie/plugin/declared_element.h"
#include "elsie/world/footprint.h"

#include "edits/room.h"
#include "plugins/guard.h"

namespace elsie::simulation {
namespace {

std::string number(double value) { return base::number_text(value); }

[[noreturn]] void refuse(const std::string& edit, const std::string& problem) {
  throw EditRefused(edit + ": " + problem);
}

bool edits_element(const Edit& edit) {
  return edit.value.starts_with('<') || edit.path.ends_with("@remove") ||
         edit.path.find("[+") != std::string::npos;
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

/// Plans edits that are made together, one attribute of a robot at a time, without changing the
/// robot.
class Plan {
 public:
  /// `setups`: parameters that earlier edits of the schedule will have set.
  Plan(const world::World& world, const InPlaceEdits::Stage& stage, const Setups& setups)
      : world_(world), stage_(stage), setups_(setups) {}

  /// Plans the next attribute; `text` is for messages: "robot[r1]/@x=3".
  void set(const world::AttributeTarget& target, const ParameterValue& value, std::string text) {
    body_ = {physics::BodyKind::robot, target.robot_index};
    if (const auto box = placed_box(world_, target)) body_ = {physics::BodyKind::obstacle, *box};
    text_ = std::move(text);
    const std::string& name = target.field.name;
    if (!target.attribute) {
      set_parameter(target, value);
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
  std::vector<InPlaceEdits::Placed> places;

 private:
  void set_parameter(const world::AttributeTarget& target, const ParameterValue& value) {
    PluginObject* const object = robot().find_object(*target.use);
    auto tuned = std::find_if(tunings.begin(), tunings.end(),
                              [&](const Tuned& other) { return other.object == object; });
    if (tuned == tunings.end()) {
      const auto known = setups_.find(object);
      tuned = tunings.insert(
          tuned, {&robot(), object, known == setups_.end() ? object->setup() : known->second, ""});
    }
    Setup& setup = tuned->setup;
    (target.nested.empty()
         ? setup.parameters
         : plugin::element_at(setup.elements, target.nested).parameters)[target.field.name] = value;
    add_text(tuned->text, text_);
  }

  Robot& robot() const { return *stage_.robots[body_.index]; }
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
  InPlaceEdits::Placed& placed() {
    auto placed = std::find_if(places.begin(), places.end(),
                               [&](const auto& other) { return other.body == body_; });
    if (placed == places.end()) {
      placed = places.insert(placed, {body_, {}, 0.0, ""});
      if (body_.kind == physics::BodyKind::obstacle) {
        placed->pose = pose_of_box(stage_.engine, world_, body_.index);
      } else {
        placed->pose = robot().truth().pose;
        placed->z = height(stage_.engine.robot(body_.index).frame);
      }
    }
    add_text(placed->text, text_);
    return *placed;
  }

  const world::World& world_;
  const InPlaceEdits::Stage& stage_;
  const Setups& setups_;
  physics::Body body_;
  std::string text_;
};

void check_tuned(const Tuned& tuned, const Cameras& cameras) {
  std::optional<Camera> camera;
  try {
    camera = tuned.robot->try_out(*tuned.object, tuned.setup);
  } catch (...) {
    refuse(tuned.text, base::what_was_thrown());
  }
  if (camera.has_value() != tuned.object->extras().camera.has_value()) {
    refuse(tuned.text, "the sensor would " + std::string(camera ? "gain" : "lose") +
                           " a camera; replace the whole element instead");
  }
  if (const auto problem = camera ? cameras.problem_of(*camera) : std::nullopt) {
    refuse(tuned.text, *problem);
  }
}

Plan plan_of(std::span<const Edit> edits, const world::World& world,
             const world::Attributes& attributes, const InPlaceEdits::Stage& stage,
             const Setups& setups) {
  Plan plan(world, stage, setups);
  for (const Edit& edit : edits) {
    try {
      for (const world::AttributeTarget& target : attributes.find(edit.path)) {
        const ParameterValue value = attributes.read(target, edit.value);
        const auto event = events::Changed::of(target.path, edit.value);
        plan.set(target, value, event.detail());
        plan.events.push_back({stage.time_s, target.robot ? target.robot->id : "", event});
      }
    } catch (const EditRefused&) {
      throw;
    } catch (const std::invalid_argument& problem) {
      refuse(edit.text(), problem.what());
    }
  }
  for (const Tuned& tuned : plan.tunings) {
    check_tuned(tuned, stage.cameras);
  }
  return plan;
}

void check_room(const std::vector<InPlaceEdits::Placed>& places, const world::World& world,
                const physics::Engine& engine) {
  if (places.empty()) return;
  Room room(world, engine);
  for (const InPlaceEdits::Placed& placed : places) {
    if (placed.body.kind == physics::BodyKind::robot) {
      room.place(placed.body.index, placed.pose, placed.z);
    } else {
      room.place_box(placed.body.index, placed.pose);
    }
  }
  for (const InPlaceEdits::Placed& placed : places) {
    if (const auto problem = room.problem_of(placed.body)) {
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
      refuse(tuned.text, base::what_was_thrown());
    }
  }
  undo.settle();
}

}  // namespace

std::optional<std::size_t> placed_box(const world::World& world,
                                      const world::AttributeTarget& target) {
  const std::vector<world::Obstacle>& boxes = world.obstacles;
  if (target.robot || !target.attribute || !target.field.is_live()) return std::nullopt;
  const auto box = std::find_if(boxes.begin(), boxes.end(), [&](const world::Obstacle& each) {
    return &each == target.described.object;
  });
  return box == boxes.end() ? std::nullopt
                            : std::optional(static_cast<std::size_t>(box - boxes.begin()));
}

Pose pose_of_box(const physics::Engine& engine, const world::World& world, std::size_t index) {
  const world::Obstacle& box = world.obstacles[index];
  if (!box.is_dynamic() || !engine.has_obstacle(index)) {
    return pose_of(box);
  }
  const Frame frame = engine.obstacle(index);
  return {frame.origin.x, frame.origin.y, std::atan2(frame.forward.y, frame.forward.x)};
}

EditRefused EditRefused::at(double time_s, std::string from) const {
  EditRefused refused("at " + number(time_s) + " s, " + what());
  refused.from_ = std::move(from);
  return refused;
}

std::string EditRefused::report() const {
  std::string text = (from_.empty() ? "--at" : from_) + ": " + what();
  for (const EditRefused& other : others_) {
    text += '\n' + other.report();
  }
  return text;
}

void EditRefused::raise(std::vector<EditRefused> refused) {
  if (!refused.empty()) {
    EditRefused first = std::move(refused.front());
    refused.erase(refused.begin());
    first.others_ = std::move(refused);
    throw first;
  }
}

bool DueEdits::come_before(double end_s, double step_s) const {
  const double begins = std::ceil(time_s / step_s - kRounding);  // steps
  return time_s >= 0.0 && time_s < end_s && begins < end_s / step_s - kRounding;
}

TimedEdit timed(const world::TimedEdit& edit) {
  return {edit.time,
          {edit.path, edit.element ? *edit.element : edit.value.value_or("")},
          file_and_line(edit.location)};
}

std::vector<TimedEdit> with_own(const world::World& world, std::span<const TimedEdit> edits) {
  std::vector<TimedEdit> all;
  for (const world::TimedEdit& edit : world.edits) {
    all.push_back(timed(edit));
  }
  all.insert(all.end(), edits.begin(), edits.end());
  return all;
}

std::vector<TimedEdit> still_to_come(const world::World& world, std::span<const TimedEdit> edits,
                                     double after_s) {
  std::vector<TimedEdit> rest = with_own(world, edits);
  std::erase_if(rest, [&](const TimedEdit& one) {
    return DueEdits{one.time_s, {}}.are_due(after_s, world.physics.step);
  });
  return rest;
}

std::vector<DueEdits> by_time(std::span<const TimedEdit> edits) {
  std::map<double, DueEdits> schedule;
  for (const TimedEdit& timed : edits) {
    DueEdits& due = schedule[timed.time_s];
    due.time_s = timed.time_s;
    due.edits.push_back(timed.edit);
    std::string& first = timed.from.empty() ? due.given : due.from;
    if (first.empty()) first = timed.from.empty() ? timed.edit.text() : timed.from;
  }
  std::vector<DueEdits> all;
  for (auto& [time_s, due] : schedule) {
    all.push_back(std::move(due));
  }
  return all;
}

InPlaceEdits::InPlaceEdits(const world::World& world, const plugin::Host& host,
                           const Options& options)
    : world_(world), attributes_(world, host, options.data_directories, options.files) {}

void InPlaceEdits::describe(std::span<const Edit> edits) const {
  for (const Edit& edit : edits) {
    for (const world::AttributeTarget& target : targets(edit)) {
      attributes_.set(target, edit.value);
    }
  }
}

bool InPlaceEdits::is_live(const Edit& edit) const {
  const auto targets = this->targets(edit);
  return !edits_element(edit) &&
         std::all_of(targets.begin(), targets.end(),
                     [](const world::AttributeTarget& target) { return target.field.is_live(); });
}

std::vector<world::AttributeTarget> InPlaceEdits::targets(const Edit& edit) const {
  try {
    return edits_element(edit) ? std::vector<world::AttributeTarget>()
                               : attributes_.find(edit.path);
  } catch (const std::invalid_argument&) {
    return {};  // make() reports the error
  }
}

std::vector<InPlaceEdits::Placed> InPlaceEdits::make(std::span<const Edit> edits,
                                                     const Stage& stage,
                                                     std::vector<EventRecord>& events) const {
  const Setups none;
  Plan plan = plan_of(edits, world_, attributes_, stage, none);
  check_room(plan.places, world_, stage.engine);
  set_up(plan.tunings);
  events.insert(events.end(), plan.events.begin(), plan.events.end());
  return std::move(plan.places);
}

std::vector<EditRefused> InPlaceEdits::refused(std::span<const DueEdits> schedule,
                                               const Stage& stage) const {
  std::vector<EditRefused> all;
  Setups setups;
  for (const DueEdits& due : schedule) {
    try {
      for (Tuned& tuned : plan_of(due.edits, world_, attributes_, stage, setups).tunings) {
        setups[tuned.object] = std::move(tuned.setup);
      }
    } catch (const EditRefused& refused) {
      all.push_back(refused.at(due.time_s, due.from));
    }
  }
  return all;
}

}  // namespace elsie::simulation

#include "physics_words.h"

#include <algorithm>

#include "elsie/base/number_text.h"
#include "elsie/base/words.h"
#include "elsie/world/parts.h"
#include "elsie/world/warnings.h"

namespace elsie::simulation {

namespace {

using About = world::Warning::About;

std::string file_and_line_of(const base::Location& location) {
  return location.line > 0 ? " (" + location.file.text() + ":" + std::to_string(location.line) + ")"
                           : "";
}

/// "the robot 'r1' (a.xml:7)"
std::string name_of(const world::World& world, const physics::Body& body,
                    std::optional<std::size_t> number) {
  if (body.kind == physics::BodyKind::robot) {
    const world::Robot& robot = world.robots.at(body.index);
    const std::string name = "the robot '" + robot.id + "'";
    const std::size_t of_drive = number ? world::driven_plan(robot).vehicles() - 1 : 0;
    if (!number || *number < of_drive) return name + file_and_line_of(robot.location);
    const world::Segment& segment = robot.segments.at(*number - of_drive);
    return "the segment '" + segment.id + "' of " + name + file_and_line_of(segment.location);
  }
  const world::Obstacle& obstacle = world.obstacles.at(body.index);
  return obstacle.in_words() + file_and_line_of(obstacle.location);
}

/// The warnings of what the physics may not simulate well.
std::vector<world::Warning> dangers(const world::World& world) {
  std::vector<world::Warning> all = world::warnings(world);
  std::erase_if(all, [](const world::Warning& each) { return each.about == About::no_effect; });
  return all;
}

/// The most likely cause of a failure: a warning about the body, else about the physics, else any.
std::string likely_cause(const world::World& world, const physics::Failure& failure) {
  const std::vector<world::Warning> all = dangers(world);
  const bool is_robot = failure.body && failure.body->kind == physics::BodyKind::robot;
  const auto rank = [&](const world::Warning& warning) {
    const bool is_of_body = failure.body && warning.index == failure.body->index &&
                            warning.about == (is_robot ? About::robot : About::obstacle);
    return is_of_body ? 2 : warning.about == About::physics ? 1 : 0;
  };
  const auto found = std::max_element(
      all.begin(), all.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  if (found != all.end()) return found->message;
  switch (failure.kind) {
    case physics::Failure::Kind::outside:
      return "it climbed over the walls, or a moving box pressed it through them";
    case physics::Failure::Kind::below_floor:
      return "more weight or force rests on it than contacts of this softness (cfm) can carry";
    default:
      return "masses, torques, speeds or places that are too extreme for this step";
  }
}

}  // namespace

void note_warnings(const world::World& world, std::vector<Note>& notes) {
  for (const world::Warning& warning : world::warnings(world)) {
    notes.push_back({"", kPhysicsNotes, warning.text()});
  }
}

void note_new_warnings(const world::World& world, double time_s, std::vector<Note>& notes) {
  for (const world::Warning& warning : world::warnings(world)) {
    if (warning.about == world::Warning::About::no_effect) continue;
    const bool is_known = std::any_of(notes.begin(), notes.end(), [&](const Note& note) {
      return note.plugin == kPhysicsNotes && note.text.ends_with(": " + warning.message);
    });
    if (!is_known) {
      notes.push_back(
          {"", kPhysicsNotes,
           "warning after an edit at " + base::seconds_text(time_s) + ": " + warning.message});
    }
  }
}

void note_give_ups(const world::World& world, const physics::GiveUps& give_ups, std::uint64_t steps,
                   std::vector<Note>& notes) {
  if (give_ups.steps == 0) return;
  std::string text = "the solver gave up in " + std::to_string(give_ups.steps) + " of " +
                     base::counted(steps, "step") + ", for the first time at " +
                     base::seconds_text(give_ups.first_s) +
                     ": it found no motion that satisfies all contacts, joints and motors, and was "
                     "run again with softer contacts";
  if (give_ups.unsolved > 0) {
    text += "; in " + base::counted(give_ups.unsolved, "step") +
            " that did not help, so a rougher solver was used";
  }
  const std::vector<world::Warning> all = dangers(world);
  text += all.empty() ? ". A smaller step, a larger cfm or less extreme masses may help."
                      : ". The likely cause: " + all.front().message + ".";
  notes.push_back({"", kPhysicsNotes, text});
}

PhysicsFault fault_of(const world::World& world, const physics::Failure& failure,
                      std::uint64_t step) {
  const bool is_robot = failure.body && failure.body->kind == physics::BodyKind::robot;
  return {
      is_robot ? world.robots.at(failure.body->index).id : "", step,
      "the physics failed after " + base::seconds_text(failure.time_s) + " (step " +
          std::to_string(step) +
          "): " + (failure.body ? name_of(world, *failure.body, failure.segment) + " " : "") +
          failure.in_words() +
          (failure.presser ? " by " + name_of(world, *failure.presser, {}) + ", which nothing stops"
                           : ". The likely cause: " + likely_cause(world, failure)) +
          "."};
}

}  // namespace elsie::simulation

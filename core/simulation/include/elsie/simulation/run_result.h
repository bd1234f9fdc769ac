// The result of a run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elsie/api/curve.h"
#include "elsie/api/geometry.h"
#include "elsie/api/measure.h"
#include "elsie/api/message.h"
#include "elsie/api/simulator_events.h"

namespace elsie::simulation {

using Outcome = RunEnd::Outcome;
using elsie::to_string;

/// The 16 hexadecimal digits of a state hash.
std::string hash_text(std::uint64_t state_hash);

/// An event on a robot, raised by the simulator or by a plugin.
struct EventRecord {
  double time_s = 0.0;  // end of the step in which it happened
  std::string robot;
  events::AnyEvent event;

  std::string name() const { return std::string(events::name_of(event)); }
  std::string detail() const { return events::detail_of(event); }
  /// The event if it is of this kind, or null: as<events::Collision>().
  template <class Kind>
  const Kind* as() const {
    return std::get_if<Kind>(&event);
  }
};

/// A note for the user: how the training of a plugin went before the run, or that a plugin changed
/// a state of the program that had to be restored. Notes of the simulator have kPhysicsNotes as
/// plugin: settings that are difficult for the physics, and how often its solver gave up.
struct Note {
  std::string robot;   // "": a note of a measure or of the simulator
  std::string plugin;  // its id on the robot
  std::string text;    // one sentence or several
};

inline constexpr const char* kPhysicsNotes = "physics";

/// A curve of a plugin; usually how a network learned before the run.
struct LearningCurve {
  std::string robot;   // "": a measure's
  std::string plugin;  // its id on the robot, after those of the behaviours that contain it:
                       // "explore/fusion_neural_network"
  Curve curve;
};

/// A measured value: one that every run has, or one of the world's measures.
struct MeasuredValue {
  std::string name;  // "path_length_m", or "ID.VALUE" of a measure; see measure_names()
  std::string unit;
  std::string meaning;
  std::optional<double> value;  // none: no value in this run
};

/// Statistics of the physics solver. It gives up in a step if it finds no motion that satisfies all
/// contacts, joints and motors; the step is then repeated with softer contacts.
struct SolverResult {
  std::uint64_t gave_up = 0;   // steps in which it gave up
  std::uint64_t unsolved = 0;  // of them, those in which softer contacts did not help
  double since_s = 0.0;        // the end of the first such step; 0 if there was none
};

struct RobotResult {
  std::string id;
  std::string team;
  double distance_m = 0.0;     // length of the path driven
  int collected = 0;           // resources
  double energy = 0.0;         // units left
  Pose pose;                   // at the end
  int collisions = 0;          // with walls, obstacles and robots; see events::Collision
  std::optional<Talk> talk{};  // none: it has no actuator that hears messages
};

struct RunResult {
  Outcome outcome = Outcome::running;
  std::string reason;  // one sentence: which goal was broken, which limit was reached
  std::uint64_t seed = 0;
  double simulated_s = 0.0;
  double wall_s = 0.0;
  std::uint64_t steps = 0;
  SolverResult solver;
  std::uint64_t state_hash = 0;  // over the state of all bodies and batteries at the end
  std::vector<RobotResult> robots;
  std::vector<EventRecord> events;
  std::vector<Note> notes;
  /// The values of every run first, then those of the world's measures in the order of the world
  /// file.
  std::vector<MeasuredValue> measures;
  std::vector<LearningCurve> curves;
};

}  // namespace elsie::simulation

// The result of a run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elsie/api/curve.h"
#include "elsie/api/geometry.h"
#include "elsie/api/measure.h"
#include "elsie/api/simulator_events.h"

namespace elsie::simulation {

using Outcome = RunEnd::Outcome;
using elsie::to_string;

/// The 16 hexadecimal digits of a state hash.
std::string hash_text(std::uint64_t state_hash);

/// Something that happened on a robot: raised by the simulator or by a plugin.
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

/// What there is to say to the user: of a plugin, how its training went before the run, or that it
/// did something to the program that had to be undone. The simulator's own notes have kPhysicsNotes
/// for a plugin: settings that the physics can hardly keep up with, and how often its solver gave
/// up.
struct Note {
  std::string robot;   // "": a measure says it, or the simulator
  std::string plugin;  // its id on the robot
  std::string text;    // one sentence or several
};

inline constexpr const char* kPhysicsNotes = "physics";

/// What a plugin has to show: how a network learned before the run, in general.
struct LearningCurve {
  std::string robot;   // "": of a measure
  std::string plugin;  // its id on the robot, behind those of the behaviours that it is inside of:
                       // "explore/fusion_neural_network"
  Curve curve;
};

/// A figure of the run: one that every run has, or one of the world's measures.
struct MeasuredValue {
  std::string name;  // "path_length_m", or "ID.VALUE" of a measure; see measure_names()
  std::string unit;
  std::string meaning;
  std::optional<double> value;  // none: there is none in this run
};

/// How the solver of the physics did. In a step in which it finds no motion that satisfies all
/// contacts, joints and motors it gives up; the step is taken again with softer contacts.
struct SolverResult {
  std::uint64_t gave_up = 0;   // steps in which it gave up
  std::uint64_t unsolved = 0;  // of them, those in which it did however soft the contacts were
  double since_s = 0.0;        // the end of the first such step; 0 if there was none
};

struct RobotResult {
  std::string id;
  std::string team;
  double distance_m = 0.0;  // length of the path driven
  int collected = 0;        // resources
  double energy = 0.0;      // units left
  Pose pose;                // at the end
  int collisions = 0;  // with walls, obstacles and robots; a touch counts anew after 0.2 s apart
};

struct RunResult {
  Outcome outcome = Outcome::running;
  std::string reason;  // one sentence: which goal was broken, which limit was met
  std::uint64_t seed = 0;
  double simulated_s = 0.0;
  double wall_s = 0.0;
  std::uint64_t steps = 0;
  SolverResult solver;
  std::uint64_t state_hash = 0;  // over the state of all bodies and batteries at the end
  std::vector<RobotResult> robots;
  std::vector<EventRecord> events;
  std::vector<Note> notes;
  /// Those of every run first, then those of the world's measures, in the order of the world file.
  std::vector<MeasuredValue> measures;
  std::vector<LearningCurve> curves;
};

}  // namespace elsie::simulation

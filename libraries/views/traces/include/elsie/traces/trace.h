// The coordination trace of a run as data: what every coordinator decided about its behaviours,
// from the first decision to the last. mcap_recorder() writes it, recording::read_trace() reads it;
// docs/explaining-a-run.md describes it.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "elsie/api/graph.h"
#include "elsie/api/motion.h"
#include "elsie/api/simulator_events.h"

namespace elsie::traces {

/// A coordinator's note about one of its behaviours. It holds from `time_s` until the next note
/// about the same behaviour, or the end. The members are those of elsie::TraceRow, rounded by
/// kept() (trace_rows.h).
struct TraceNote {
  double time_s = 0.0;  // of the decision
  Motion command;
  double activation = 0.0;
  double strength = 0.0;
  double weight = 0.0;
  double share = 0.0;        // in the command of its own coordinator
  int inhibited_by = -1;     // place among the members of the robot; -1: none
  std::uint32_t reason = 0;  // place in Trace::reasons
  bool asked = false;        // otherwise command, activation and strength are zero
};

/// The time that a behaviour took to answer, if it was measured.
struct TraceTimes {
  std::uint64_t answers = 0;
  double mean_s = 0.0;
  double longest_s = 0.0;
};

/// One behaviour of a robot, at whatever depth.
struct TraceMember {
  std::string path;              // ids from the robot on: "explore/avoid_obstacle"
  std::string plugin;            // the behaviour's
  std::string coordinator;       // the plugin that decides about it
  double priority = 1.0;         // as the world file sets it
  int depth = 0;                 // 0: the robot's own
  int parent = -1;               // index of the behaviour around it; -1: none
  std::vector<TraceNote> notes;  // ascending in time
  TraceTimes times;
};

struct TraceEvent {
  double time_s = 0.0;
  std::string name;
  std::string detail;
  std::optional<events::Changed> changed{};  // the edit, for `changed`
};

/// A number that a plugin of a robot published, at each sample of the recording.
struct TraceNumber {
  std::string path;  // of the plugin: "explore/avoid_obstacle"
  std::string name;
  std::string unit;  // may be empty
  struct Sample {
    double time_s = 0.0;
    double value = 0.0;  // NaN: there was none
  };
  std::vector<Sample> samples;  // ascending in time
};

/// A command that an actuator carries out from a sample of the recording on.
struct TraceCommand {
  double time_s = 0.0;
  std::string by;    // path of the behaviour that gave it; empty: none has given one
  std::string text;  // its numbers: "red 255, brightness 1"
};

/// An actuator of a robot, from its first command on. One that an edit removes and another one adds
/// again is two.
struct TraceActuator {
  std::string id;
  std::vector<TraceCommand> commands;  // ascending in time; each differs from the one before
  double to_s = std::numeric_limits<double>::infinity();  // the first sample without it
};

/// A message that a robot heard.
struct TraceHeard {
  double time_s = 0.0;  // of the decision before which it was heard
  std::string device;   // the id of the actuator that heard it
  std::string from;     // the id of the robot that said it; empty: the device does not tell
  std::string kind;
  std::string text;  // its numbers
};

/// The graph of one of a robot's coordinators, while it stayed the same.
struct TraceGraph {
  std::string path;    // ids from the robot on: "explore/arbiter_tree"
  std::string plugin;  // the coordinator's
  Graph graph;
  /// What the nodes are, from a decision until the next one that is here.
  struct Lights {
    double time_s = 0.0;
    std::vector<NodeState> nodes;
  };
  std::vector<Lights> lights{};  // ascending in time
  double to_s = std::numeric_limits<double>::infinity();
};

/// A robot with its behaviours during a time. If an edit changes the behaviours, another TraceRobot
/// with the same id begins.
struct TraceRobot {
  std::string id;
  std::string team;
  std::string coordinator;           // its own, the outermost
  std::vector<TraceMember> members;  // each before those inside it, in file order
  std::vector<TraceEvent> events;
  std::vector<TraceNumber> numbers{};
  std::vector<TraceActuator> actuators{};
  std::vector<TraceHeard> heard{};   // ascending in time
  std::vector<TraceGraph> graphs{};  // of those that an edit changed, the earlier one first
  /// The time during which it is in the world with these behaviours, s.
  double from_s = 0.0;
  double to_s = std::numeric_limits<double>::infinity();
};

/// True if both are one robot with the same behaviours under the same coordinators.
bool same_cast(const TraceRobot& a, const TraceRobot& b);

struct Trace {
  std::string world;       // its name
  std::string world_file;  // may be empty
  std::uint64_t seed = 0;
  double step_s = 0.0;
  double period_s = 0.0;  // between two decisions
  std::vector<TraceRobot> robots;
  std::set<std::string> without_decisions{};  // ids of the robots whose decisions nobody recorded
  std::vector<std::string> reasons;           // the first one is empty
  /// The end of the trace: the end of the run if the trace has it, else the last message or the end
  /// of the last control period with a decision, whichever is later.
  double end_s = 0.0;
  /// "success", "failure", "time_limit"; "stopped": a plugin that failed or the user ended the run;
  /// empty: the trace has no end, because the program was killed or is still running.
  std::string outcome;
  std::string outcome_reason;
  /// A sentence about an end that is missing; empty: the trace has its end.
  std::string cut_off;
};

}  // namespace elsie::traces

// The coordination trace of a run as data: what every coordinator made of its behaviours, from the
// first decision to the last. TraceRecorder writes it, read_trace() reads it back;
// docs/explaining-a-run.md describes the file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "elsie/api/motor_command.h"
#include "elsie/base/error.h"

namespace elsie::traces {

/// What a coordinator noted about one of its behaviours. It holds from `time_s` until the next note
/// about the same behaviour, or the end. The members are those of elsie::TraceRow.
struct TraceNote {
  double time_s = 0.0;  // of the decision
  MotorCommand command;
  double activation = 0.0;
  double strength = 0.0;
  double weight = 0.0;
  double share = 0.0;        // in the command of its own coordinator
  int inhibited_by = -1;     // place among the members of the robot; -1: none
  std::uint32_t reason = 0;  // place in Trace::reasons
  bool asked = false;        // otherwise command, activation and strength are zero
};

/// How long a behaviour took to answer, where that was measured.
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
  int parent = -1;               // place of the behaviour that it is inside of; -1: none
  std::vector<TraceNote> notes;  // ascending in time
  TraceTimes times;
};

/// A change of what a robot's motors are told.
struct TraceCommand {
  double time_s = 0.0;
  MotorCommand command;
};

struct TraceEvent {
  double time_s = 0.0;
  std::string name;
  std::string detail;
};

struct TraceRobot {
  std::string id;
  std::string team;
  std::string coordinator;           // its own, the outermost
  std::vector<TraceMember> members;  // each before those inside it, in file order
  std::vector<TraceCommand> commands;
  std::vector<TraceEvent> events;
};

struct Trace {
  std::string world;       // its name
  std::string world_file;  // may be empty
  std::uint64_t seed = 0;
  double step_s = 0.0;
  double period_s = 0.0;  // between two decisions
  std::vector<TraceRobot> robots;
  std::vector<std::string> reasons;  // the first one is empty
  /// How far the trace goes: the end of the run if that is in it, else the end of the last control
  /// period of which there is something.
  double end_s = 0.0;
  /// "success", "failure", "time_limit"; "stopped": the run was ended by a plugin that failed or by
  /// the user; empty: the trace has no end, because the program was killed or is still at work.
  std::string outcome;
  std::string outcome_reason;
  /// A sentence about a last line that is cut off and was left out; empty: there is none.
  std::string cut_off;
};

/// A file that is no trace or is damaged; what() is a sentence with file and line, with what was
/// found and what was expected.
class TraceError : public base::Error {
 public:
  using base::Error::Error;
};

/// Reads a trace. A file without its end, even one that ends in the middle of a line, is read as
/// far as it is whole; see Trace::outcome and Trace::cut_off. Anything else that is not as the
/// recorder writes it throws TraceError; so does a file that cannot be opened or has no complete
/// head.
Trace read_trace(const std::filesystem::path& file);

/// Whether the file begins as a trace does, of whatever version; an empty file counts, too. False
/// for one that cannot be read.
bool may_be_trace(const std::filesystem::path& file);

}  // namespace elsie::traces

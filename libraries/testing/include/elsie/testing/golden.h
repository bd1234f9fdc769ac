// Golden traces: earlier results in a committed text file, compared with those of today.
//
// Tests write the file when the environment variable ELSIE_UPDATE_GOLDEN is 1; check the changes
// before committing it.
#pragma once

#include <string>
#include <vector>

#include "elsie/testing/behavior.h"
#include "elsie/testing/coordinator.h"
#include "elsie/testing/verdict.h"
#include "elsie/testing/world.h"

namespace elsie::testing {

/// The environment variable that makes tests rewrite golden files.
inline constexpr const char* kUpdateVariable = "ELSIE_UPDATE_GOLDEN";

/// A table with a row for each step: numbers by name, and events.
struct Trace {
  struct Row {
    double time_s = 0.0;
    std::vector<double> values;  // one for each column
    std::string events;          // names, separated by commas
  };
  std::vector<std::string> columns;
  std::vector<Row> rows;
};

/// A behaviour's answers: forward, lateral (m/s), turn (rad/s), activation, strength, and events.
/// Its commands to actuators stand after the events: act:KIND or act:ACTUATOR:KIND, and what it
/// says with the kind of the message and the receiver, act:say:offer:r2.
Trace record(Behavior& behavior, const Sequence& sequence);
/// A coordinator's decisions: forward, lateral (m/s), turn (rad/s), and the share of each of its
/// members.
Trace record(Coordinator& coordinator, Team& team, const Sequence& sequence);
/// A world from its present state: every `interval_s`, for each robot x, y (m), heading (rad) and
/// its command (m/s, rad/s), each number of the commands that its actuators carry out
/// (r1.gripper.closed), and the events since the row before. Throws simulation::PluginFault.
Trace record(World& world, double seconds, double interval_s = 0.1);

/// Whether the trace equals that of the file: the same columns, steps and events, and numbers
/// within `tolerance`, absolute or relative to the larger one. If not, the sentence gives the first
/// difference, with step, value and expected value, and the number of differences. A missing file
/// is a difference, too. Throws std::runtime_error when the file should be written and cannot be.
Verdict compare_with_golden(const Trace& trace, const std::string& file, double tolerance = 1e-6);

/// The text of a golden file. read_trace() throws std::runtime_error with file and line when the
/// text is no golden trace.
std::string write_trace(const Trace& trace);
Trace read_trace(const std::string& text, const std::string& file);

}  // namespace elsie::testing

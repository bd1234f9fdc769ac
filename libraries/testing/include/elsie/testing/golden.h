// Golden traces: what came of it once, in a text file that is committed, against what comes of it
// now.
//
// A file is written when the environment variable ELSIE_UPDATE_GOLDEN is set to 1; look at what
// changed before committing it.
#pragma once

#include <string>
#include <vector>

#include "elsie/testing/behavior.h"
#include "elsie/testing/coordinator.h"
#include "elsie/testing/verdict.h"
#include "elsie/testing/world.h"

namespace elsie::testing {

/// Name of the environment variable that has golden files rewritten.
inline constexpr const char* kUpdateVariable = "ELSIE_UPDATE_GOLDEN";

/// A table: numbers by name, and the events, for each step.
struct Trace {
  struct Row {
    double time_s = 0.0;
    std::vector<double> values;  // as many as there are columns
    std::string events;          // names with commas between; empty: none
  };
  std::vector<std::string> columns;
  std::vector<Row> rows;
};

/// A behaviour's answers: left, right (rad/s), activation, strength; and its events.
Trace record(Behavior& behavior, const Sequence& sequence);
/// A coordinator's decisions: left, right (rad/s), and the share of each of its members.
Trace record(Coordinator& coordinator, Team& team, const Sequence& sequence);
/// A world from where it is: for each robot x, y (m), heading (rad) and its command (rad/s), at
/// every `interval_s`; with the events since the row before. Throws simulation::PluginFault.
Trace record(World& world, double seconds, double interval_s = 0.1);

/// Whether the trace is the one in the file: the same columns, steps and events; numbers no further
/// off than `tolerance`, or that part of the larger of the two. When not, the sentence tells the
/// first difference, with step, value and what was expected, and how many there are. A file that is
/// not there is a difference, too. Throws std::runtime_error when the file is to be written and
/// cannot be.
Verdict compare_with_golden(const Trace& trace, const std::string& file, double tolerance = 1e-6);

/// The text of a golden file. read_trace() throws std::runtime_error, with file and line, for text
/// that is none.
std::string write_trace(const Trace& trace);
Trace read_trace(const std::string& text, const std::string& file);

}  // namespace elsie::testing

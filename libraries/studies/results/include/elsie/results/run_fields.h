// The fields of a run, each declared once. The answer of a worker, the columns of the table `runs`,
// and those of a CSV report follow from this list.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "elsie/results/run_state.h"
#include "elsie/simulation/run_result.h"

namespace elsie::results {

using simulation::Outcome;

struct RunFields {
  RunState state = RunState::pending;
  std::optional<Outcome> outcome;  // of a run that is done
  std::string message;             // one sentence: why it ended, what failed; may be empty
  std::optional<std::uint64_t> steps;
  std::optional<double> simulated_s;
  std::optional<std::string> state_hash;  // 16 hexadecimal digits
  std::optional<std::string> signal;      // "SIGSEGV"
  std::optional<int> exit_code;           // of the process, if it ended by itself
  std::optional<std::string> plugin;      // that was running when it failed
  std::optional<std::string> robot;
  std::optional<std::uint64_t> step;
  std::optional<double> wall_s;
  std::optional<std::uint64_t> solver_gave_up;   // in steps, as in simulation::SolverResult
  std::optional<std::uint64_t> solver_unsolved;  // of them
  std::optional<std::string> log;  // the end of the output of a process that ended abnormally
};

/// Calls `visit(name, value)` for each field of a RunFields.
template <class Fields, class Visit>
void for_each_field(Fields& run, Visit visit) {
  visit("state", run.state);
  visit("outcome", run.outcome);
  visit("message", run.message);
  visit("steps", run.steps);
  visit("simulated_s", run.simulated_s);
  visit("state_hash", run.state_hash);
  visit("signal", run.signal);
  visit("exit_code", run.exit_code);
  visit("plugin", run.plugin);
  visit("robot", run.robot);
  visit("step", run.step);
  visit("wall_s", run.wall_s);
  visit("solver_gave_up", run.solver_gave_up);
  visit("solver_unsolved", run.solver_unsolved);
  visit("log", run.log);
}

/// The names of all fields, each followed by `after`: "state, outcome, ...".
std::string field_names(const std::string& after = "");

/// The columns of all fields in the table `runs`, as SQL: "state TEXT NOT NULL, ...".
std::string field_columns();

/// Converts a word of the database to an outcome; none for any other word.
std::optional<Outcome> outcome_of(const std::string& word);

namespace sqlite {
class Statement;
}
/// Binds all fields in order, starting at this place. Returns the next place.
int bind_fields(sqlite::Statement& statement, int place, const RunFields& run);
/// Reads all fields in order, starting at this column.
void read_fields(const sqlite::Statement& statement, int column, RunFields& run);

}  // namespace elsie::results

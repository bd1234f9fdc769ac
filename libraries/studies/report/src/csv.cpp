#include "elsie/base/csv.h"

#include <set>
#include <string>
#include <vector>

#include "elsie/report/report.h"

#include "numbers.h"

namespace elsie::report {

namespace {

std::string line(const std::vector<std::string>& cells) {
  std::string text;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    text += (i ? "," : "") + base::csv_cell(cells[i]);
  }
  return text + '\n';
}

template <class T>
std::string optional_text(const std::optional<T>& value) {
  return value ? std::to_string(*value) : "";
}

std::string optional_text(const std::optional<double>& value) {
  return value ? number_text(*value) : "";
}

// In a world without goals, a run does not fail by ending at the time limit.
std::string outcome_of(const Findings& findings, const Run& run) {
  if (run.outcome == Outcome::time_limit && !findings.cells[run.cell].goals) {
    return "no_goals";
  }
  return run.outcome ? simulation::to_string(*run.outcome) : "";
}

}  // namespace

std::string csv_report(const Findings& findings) {
  const Results& results = findings.results;
  std::vector<std::string> heads{
      "run",     "cell",  "seed",        "repetition", "state",          "outcome",
      "message", "steps", "simulated_s", "state_hash", "signal",         "exit_code",
      "plugin",  "robot", "step",        "wall_s",     "solver_gave_up", "solver_unsolved"};
  std::set<std::string> taken(heads.begin(), heads.end());
  const auto add = [&](const std::string& name, const std::string& otherwise) {
    heads.push_back(taken.insert(name).second ? name : otherwise + name);
  };
  for (const Factor& factor : results.factors) {
    add(factor.name, "factor:");
  }
  for (const Measure& measure : results.measures) {
    add(measure.name, "measure:");
  }
  std::string text = line(heads);
  for (const Run& run : results.runs) {
    const CellInfo& cell = results.cells[run.cell];
    std::vector<std::string> cells{std::to_string(run.id),
                                   cell.label,
                                   std::to_string(run.seed),
                                   std::to_string(run.repetition),
                                   to_string(run.state),
                                   outcome_of(findings, run),
                                   run.message,
                                   optional_text(run.steps),
                                   optional_text(run.simulated_s),
                                   run.state_hash,
                                   run.signal,
                                   optional_text(run.exit_code),
                                   run.plugin,
                                   run.robot,
                                   optional_text(run.step),
                                   optional_text(run.wall_s),
                                   optional_text(run.solver_gave_up),
                                   optional_text(run.solver_unsolved)};
    cells.insert(cells.end(), cell.levels.begin(), cell.levels.end());
    for (std::size_t i = 0; i < run.values.size(); ++i) {
      const bool unasked = !findings.cells[run.cell].goals && results.measures[i].name == kSuccess;
      cells.push_back(unasked ? "" : optional_text(run.values[i]));
    }
    text += line(cells);
  }
  return text;
}

}  // namespace elsie::report

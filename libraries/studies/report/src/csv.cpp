#include <set>
#include <string>
#include <vector>

#include "elsie/files/csv_line.h"
#include "elsie/report/report.h"

#include "numbers.h"

namespace elsie::report {

namespace {

std::string line(const std::vector<std::string>& cells) {
  std::string text;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    text += (i ? "," : "") + files::csv_cell(cells[i]);
  }
  return text + '\n';
}

std::string text_of(const std::string& text) { return text; }
std::string text_of(double number) { return number_text(number); }
template <class Whole>
std::string text_of(Whole number) {
  return std::to_string(number);
}

template <class T>
std::string optional_text(const std::optional<T>& value) {
  return value ? text_of(*value) : "";
}

// In a world without goals, a run that ends at the time limit has not failed.
std::string outcome_of(const Findings& findings, const Run& run) {
  if (run.outcome == Outcome::time_limit && !findings.cells[run.cell].goals) {
    return "no_goals";
  }
  return run.outcome ? simulation::to_string(*run.outcome) : "";
}

/// A log of several lines does not fit into a table.
bool in_table(std::string_view field) { return field != "log"; }

struct FieldCells {
  std::vector<std::string>& cells;
  const std::string& outcome;

  void operator()(const char*, results::RunState state) { cells.emplace_back(to_string(state)); }
  void operator()(const char*, const std::optional<Outcome>&) { cells.push_back(outcome); }
  void operator()(const char*, const std::string& text) { cells.push_back(text); }
  template <class T>
  void operator()(const char* name, const std::optional<T>& value) {
    if (in_table(name)) {
      cells.push_back(optional_text(value));
    }
  }
};

// What is known of a measure in a cell, in the order of kMeasureHeads.
constexpr const char* kMeasureHeads[] = {
    "n",      "mean",           "sd",      "low",    "high", "least", "lower_quartile",
    "median", "upper_quartile", "largest", "bounds", "limit"};

void add_measure(const MeasureFindings& found, std::vector<std::string>& cells) {
  const auto& all = found.all;
  const auto& censoring = found.censoring;
  const auto of_all = [&](double Summary::*part) { return all ? text_of((*all).*part) : ""; };
  cells.push_back(std::to_string(found.values.size()));
  cells.push_back(of_all(&Summary::mean));
  cells.push_back(all ? optional_text(all->standard_deviation) : "");
  cells.push_back(found.interval ? text_of(found.interval->low) : "");
  cells.push_back(found.interval ? text_of(found.interval->high) : "");
  cells.push_back(of_all(&Summary::least));
  cells.push_back(of_all(&Summary::lower_quartile));
  cells.push_back(censoring ? optional_text(censoring->median) : of_all(&Summary::median));
  cells.push_back(of_all(&Summary::upper_quartile));
  cells.push_back(of_all(&Summary::largest));
  cells.push_back(std::to_string(censoring ? censoring->count : 0));
  cells.push_back(censoring ? optional_text(censoring->limit) : "");
}

}  // namespace

std::string cells_csv(const Findings& findings) {
  const Results& results = findings.results;
  std::vector<std::string> heads{"cell",         "runs",   "successes", "success_low",
                                 "success_high", "broken", "pending"};
  std::set<std::string> taken(heads.begin(), heads.end());
  for (const Factor& factor : results.factors) {
    heads.push_back(taken.insert(factor.name).second ? factor.name : "factor:" + factor.name);
  }
  for (const std::size_t place : findings.measures) {
    for (const char* const head : kMeasureHeads) {
      heads.push_back(results.measures[place].name + ":" + head);
    }
  }
  std::string text = line(heads);
  for (std::size_t i = 0; i < findings.cells.size(); ++i) {
    const CellFindings& cell = findings.cells[i];
    std::vector<std::string> cells{results.cells[i].label, std::to_string(cell.ended)};
    cells.push_back(cell.goals ? std::to_string(cell.successes) : "");
    cells.push_back(cell.goals ? text_of(cell.success.low) : "");
    cells.push_back(cell.goals ? text_of(cell.success.high) : "");
    cells.push_back(std::to_string(cell.broken.size()));
    cells.push_back(std::to_string(cell.pending));
    cells.insert(cells.end(), results.cells[i].levels.begin(), results.cells[i].levels.end());
    for (const MeasureFindings& found : cell.measures) {
      add_measure(found, cells);
    }
    text += line(cells);
  }
  return text;
}

std::string csv_report(const Findings& findings) {
  const Results& results = findings.results;
  std::vector<std::string> heads{"run", "cell", "seed", "repetition"};
  const Run any;
  for_each_field(any, [&](const char* name, const auto&) {
    if (in_table(name)) {
      heads.emplace_back(name);
    }
  });
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
    std::vector<std::string> cells{std::to_string(run.id), cell.label, std::to_string(run.seed),
                                   std::to_string(run.repetition)};
    for_each_field(run, FieldCells{cells, outcome_of(findings, run)});
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

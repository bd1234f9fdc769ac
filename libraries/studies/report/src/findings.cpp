#include "elsie/report/findings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "elsie/report/factors.h"
#include "elsie/report/survival.h"

#include "goals.h"
#include "judge.h"

namespace elsie::report {

namespace {

std::vector<std::size_t> shown_measures(const Results& results,
                                        const std::vector<std::string>& names) {
  std::vector<std::size_t> shown;
  const auto place_of = [&](const std::string& name) {
    const auto found = std::find_if(results.measures.begin(), results.measures.end(),
                                    [&](const Measure& measure) { return measure.name == name; });
    return static_cast<std::size_t>(found - results.measures.begin());
  };
  for (const std::string& name : names) {
    const std::size_t place = place_of(name);
    if (place < results.measures.size() && name != kSuccess) {
      shown.push_back(place);
    }
  }
  for (std::size_t i = 0; names.empty() && i < results.measures.size(); ++i) {
    if (results.measures[i].name != kSuccess) {
      shown.push_back(i);
    }
  }
  return shown;
}

bool has(const Run& run, std::size_t measure) {
  return run.state == RunState::done && run.values[measure] && is_usable(*run.values[measure]);
}

// Bounds count as larger than all known values.
Censoring censoring_of(std::vector<double> known, const std::vector<double>& limits,
                       std::size_t failures) {
  Censoring result;
  result.count = limits.size() + failures;
  result.failures = failures;
  if (!limits.empty()) {
    result.limit = *std::min_element(limits.begin(), limits.end());
  }
  if (!known.empty()) {
    result.least = *std::min_element(known.begin(), known.end());
  }
  // At risk until the last of them is over, as in the curve of the cell.
  std::vector<Observed> observed;
  double longest = limits.empty() ? 0.0 : *std::max_element(limits.begin(), limits.end());
  for (const double value : known) {
    observed.push_back({value, false});
    longest = std::max(longest, value);
  }
  observed.resize(known.size() + result.count, {longest, true});
  known.resize(observed.size(), std::numeric_limits<double>::infinity());
  std::sort(known.begin(), known.end());
  if (const double median = quantile(known, 0.5); std::isfinite(median)) {
    result.median = median;
    result.median_interval = survival_of(observed, kConfidence).median_interval;
  }
  return result;
}

MeasureFindings look_at(const Findings& findings, const CellFindings& cell, std::size_t measure) {
  const Results& results = findings.results;
  MeasureFindings found;
  std::vector<double> successes, known, limits;
  std::size_t failures = 0;
  for (const std::size_t place : cell.runs) {
    const Run& run = results.runs[place];
    if (!has(run, measure)) {
      continue;
    }
    found.values.push_back(*run.values[measure]);
    if (findings.is_censored(run, measure) && run.outcome == Outcome::failure) {
      ++failures;
    } else {
      (findings.is_censored(run, measure) ? limits : known).push_back(found.values.back());
    }
    if (run.success()) {
      successes.push_back(found.values.back());
    }
  }
  found.successes = summary(successes);
  if (!limits.empty() || failures > 0) {
    found.censoring = censoring_of(std::move(known), limits, failures);
    return found;
  }
  found.all = summary(found.values);
  // All cells use the same random draws, so that equal values give equal intervals.
  found.interval =
      mean_interval(found.values, kConfidence, results.seed(), results.measures[measure].name);
  if (found.values.size() >= kFewest) {
    found.fences = tukey_fences(*found.all);
  }
  return found;
}

void collect_outliers(const Findings& findings, CellFindings& cell) {
  for (std::size_t i = 0; i < findings.measures.size(); ++i) {
    const MeasureFindings& found = cell.measures[i];
    if (!found.fences) {
      continue;
    }
    const double range = found.all->quartile_range();
    for (const std::size_t place : cell.runs) {
      const Run& run = findings.results.runs[place];
      if (!has(run, findings.measures[i])) {
        continue;
      }
      const double value = *run.values[findings.measures[i]];
      if (!found.stands_out(value)) {
        continue;
      }
      const double outside = std::max(found.fences->low - value, value - found.fences->high);
      cell.outliers.push_back(
          {place, findings.measures[i], value,
           range > found.rounding() ? outside / range : std::numeric_limits<double>::infinity()});
    }
  }
  std::stable_sort(cell.outliers.begin(), cell.outliers.end(),
                   [](const Outlier& a, const Outlier& b) { return a.beyond > b.beyond; });
}

void sort_out_runs(Findings& findings) {
  const Results& results = findings.results;
  findings.cells.resize(results.cells.size());
  std::map<std::pair<std::size_t, std::uint64_t>, std::vector<std::size_t>> alike;
  std::map<std::tuple<std::uint64_t, std::string, std::uint64_t>, std::size_t> first_of;
  for (std::size_t i = 0; i < results.runs.size(); ++i) {
    const Run& run = results.runs[i];
    const bool is_known = run.state == RunState::done && run.state_hash;
    findings.originals.push_back(
        is_known ? first_of.try_emplace({run.seed, *run.state_hash, run.steps.value_or(0)}, i)
                       .first->second
                 : i);
    CellFindings& cell = findings.cells[run.cell];
    std::vector<std::size_t>& same = alike[{run.cell, run.seed}];
    if (same.empty()) {
      cell.runs.push_back(i);
    }
    same.push_back(i);
    if (!run.ended()) {
      ++cell.pending;
    }
    if (run.broken()) {
      cell.broken.push_back(i);
    }
  }
  for (CellFindings& cell : findings.cells) {
    cell.one_run = cell.runs.size() > 1 &&
                   std::all_of(cell.runs.begin(), cell.runs.end(), [&](std::size_t place) {
                     const Run& run = results.runs[place];
                     return run.state == RunState::done &&
                            run.state_hash == results.runs[cell.runs.front()].state_hash;
                   });
  }
  for (const auto& [what, runs] : alike) {
    std::vector<std::size_t> done;
    for (const std::size_t run : runs) {
      if (results.runs[run].state == RunState::done) {
        done.push_back(run);
      }
    }
    const bool differ = std::any_of(done.begin(), done.end(), [&](std::size_t run) {
      return results.runs[run].state_hash != results.runs[done.front()].state_hash;
    });
    if (differ) {
      findings.disagreements.push_back({done});
    }
  }
}

}  // namespace

double MeasureFindings::rounding() const {
  return 1e-12 * std::max(std::abs(all->least), std::abs(all->largest));
}

bool MeasureFindings::stands_out(double value) const {
  return fences && std::max(fences->low - value, value - fences->high) > rounding();
}

bool Verdict::met() const {
  return trouble.empty() &&
         std::all_of(claims.begin(), claims.end(), [](const Claim& claim) { return claim.holds; });
}

bool Verdict::open() const {
  if (!trouble.empty()) {
    return waits;
  }
  return !met() && std::all_of(claims.begin(), claims.end(),
                               [](const Claim& claim) { return claim.holds || claim.open; });
}

std::size_t Findings::ended() const {
  return static_cast<std::size_t>(std::count_if(results.runs.begin(), results.runs.end(),
                                                [](const Run& run) { return run.ended(); }));
}

std::size_t Findings::broken() const {
  return static_cast<std::size_t>(std::count_if(results.runs.begin(), results.runs.end(),
                                                [](const Run& run) { return run.broken(); }));
}

bool Findings::missed(const Run& run) const {
  return run.state == RunState::done && !run.success() &&
         (cells[run.cell].goals || run.outcome == Outcome::failure);
}

bool Findings::is_censored(const Run& run, std::size_t measure) const {
  return never_arrived(run, cells[run.cell].goals) &&
         (results.measures[measure].name == kTime ||
          std::find(run.bounds.begin(), run.bounds.end(), measure) != run.bounds.end());
}

bool Findings::any_goals() const {
  return std::any_of(cells.begin(), cells.end(),
                     [](const CellFindings& cell) { return cell.goals; });
}

bool Findings::good() const {
  return !partial() && pending() == 0 && broken() == 0 && disagreements.empty() &&
         std::all_of(verdicts.begin(), verdicts.end(),
                     [](const Verdict& verdict) { return verdict.met(); });
}

bool Findings::open() const {
  return (partial() || pending() > 0) && broken() == 0 && disagreements.empty() &&
         std::all_of(verdicts.begin(), verdicts.end(),
                     [](const Verdict& verdict) { return verdict.met() || verdict.open(); });
}

Findings find(Results results, const Questions& questions) {
  Findings findings;
  findings.results = std::move(results);
  findings.measures = shown_measures(findings.results, questions.measures);
  sort_out_runs(findings);
  for (const std::size_t measure : findings.measures) {
    double& largest = findings.largest.emplace_back(-std::numeric_limits<double>::infinity());
    for (const Run& run : findings.results.runs) {
      largest = has(run, measure) ? std::max(largest, *run.values[measure]) : largest;
    }
  }
  const std::vector<bool> goals = cells_with_goals(findings.results);
  for (std::size_t i = 0; i < findings.cells.size(); ++i) {
    CellFindings& cell = findings.cells[i];
    cell.goals = goals[i];
    for (const std::size_t place : cell.runs) {
      const Run& run = findings.results.runs[place];
      cell.ended += run.ended() ? 1 : 0;
      cell.successes += run.success() ? 1 : 0;
    }
    cell.success = wilson_interval(cell.successes, cell.ended, kConfidence);
    for (const std::size_t measure : findings.measures) {
      cell.measures.push_back(look_at(findings, cell, measure));
    }
    collect_outliers(findings, cell);
  }
  const experiment::Grid grid = grid_of(findings.results);
  for (const experiment::Expectation& expectation : questions.expectations) {
    findings.verdicts.push_back(judge(expectation, findings, grid));
  }
  return findings;
}

}  // namespace elsie::report

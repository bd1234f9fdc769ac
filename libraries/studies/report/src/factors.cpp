#include "elsie/report/factors.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "elsie/experiment/formula_names.h"

#include "numbers.h"

namespace elsie::report {

namespace {

std::optional<Observed> observed(const Findings& findings, const Response& response,
                                 const Run& run) {
  if (!response.measure) {
    return run.ended() && findings.cells[run.cell].goals
               ? std::optional(Observed{run.success() ? 1.0 : 0.0, false})
               : std::nullopt;
  }
  const std::size_t place = findings.measures[*response.measure];
  if (run.state != RunState::done || !run.values[place] || !is_usable(*run.values[place])) {
    return std::nullopt;
  }
  const bool bound = findings.is_censored(run, place);
  // A run that failed never reaches its goals: it counts as longer than all others.
  const bool never = bound && run.outcome == Outcome::failure;
  return Observed{never ? findings.largest[*response.measure] : *run.values[place], bound};
}

}  // namespace

std::vector<std::size_t> VariedFactor::cells_at(std::size_t level) const {
  std::vector<std::size_t> cells;
  for (std::size_t i = 0; i < of_cell.size(); ++i) {
    if (of_cell[i] == level) {
      cells.push_back(i);
    }
  }
  return cells;
}

std::vector<std::vector<std::size_t>> VariedFactor::groups() const {
  std::vector<std::vector<std::size_t>> all;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    all.push_back(cells_at(level));
  }
  return all;
}

experiment::Grid grid_of(const Results& results) {
  std::vector<std::string> factors;
  for (const Factor& factor : results.factors) {
    factors.push_back(factor.name);
  }
  std::vector<std::vector<std::string>> cells;
  for (const CellInfo& cell : results.cells) {
    cells.push_back(cell.levels);
  }
  return {std::move(factors), std::move(cells)};
}

std::vector<std::string> levels_without(const CellInfo& cell,
                                        const std::vector<std::size_t>& factors) {
  std::vector<std::string> levels = cell.levels;
  for (const std::size_t factor : factors) {
    levels[factor].clear();
  }
  return levels;
}

std::vector<VariedFactor> varied_factors(const Results& results) {
  std::vector<VariedFactor> all;
  for (std::size_t factor = 0; factor < results.factors.size(); ++factor) {
    std::map<int, std::string> by_place;
    for (const CellInfo& cell : results.cells) {
      by_place.emplace(cell.places[factor], cell.levels[factor]);
    }
    if (by_place.size() < 2) {
      continue;
    }
    VariedFactor one{factor, results.factors[factor].name, {}, {}, {}};
    std::vector<int> places;
    std::map<double, int> by_number;
    for (const auto& [place, label] : by_place) {
      places.push_back(place);
      if (const auto number = experiment::number_in(label); number && is_usable(*number)) {
        by_number.emplace(*number, place);
      }
    }
    if (by_number.size() == by_place.size()) {
      places.clear();
      for (const auto& [number, place] : by_number) {
        one.numbers.push_back(number);
        places.push_back(place);
      }
    }
    for (const int place : places) {
      one.levels.push_back(by_place.at(place));
    }
    for (const CellInfo& cell : results.cells) {
      const auto found = std::find(places.begin(), places.end(), cell.places[factor]);
      one.of_cell.push_back(static_cast<std::size_t>(found - places.begin()));
    }
    all.push_back(std::move(one));
  }
  return all;
}

std::vector<Response> responses(const Findings& findings) {
  std::vector<Response> all;
  if (findings.any_goals()) {
    all.push_back({std::nullopt, kSuccess, kSuccess, ""});
  }
  for (std::size_t i = 0; i < findings.measures.size(); ++i) {
    const Measure& measure = findings.results.measures[findings.measures[i]];
    all.push_back({i, measure.name, in_words(measure.name, measure.unit), measure.unit});
  }
  return all;
}

std::vector<Observation> observations(const Findings& findings, const Response& response,
                                      const std::vector<std::size_t>& cells) {
  std::vector<Observation> all;
  for (const std::size_t cell : cells) {
    for (const std::size_t place : findings.cells[cell].runs) {
      const Run& run = findings.results.runs[place];
      if (const auto of = observed(findings, response, run)) {
        all.push_back({run.seed, cell, *of, findings.originals[place]});
      }
    }
  }
  return all;
}

std::vector<std::size_t> all_cells(const Findings& findings) {
  std::vector<std::size_t> cells(findings.cells.size());
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  return cells;
}

bool is_constant(const Findings& findings, const Response& response) {
  const std::vector<Observation> all = observations(findings, response, all_cells(findings));
  if (all.empty()) {
    return true;
  }
  const auto [least, largest] = std::minmax_element(
      all.begin(), all.end(), [](const auto& a, const auto& b) { return a.of.value < b.of.value; });
  return are_equal(least->of.value, largest->of.value) &&
         std::all_of(all.begin(), all.end(),
                     [&](const Observation& one) { return one.of.bound == all.front().of.bound; });
}

std::vector<std::size_t> common(const std::vector<std::size_t>& first,
                                const std::vector<std::size_t>& second) {
  std::vector<std::size_t> both;
  std::set_intersection(first.begin(), first.end(), second.begin(), second.end(),
                        std::back_inserter(both));
  return both;
}

std::vector<Observed> times_to_goals(const Findings& findings, std::size_t cell) {
  const auto& measures = findings.results.measures;
  const auto time = std::find_if(measures.begin(), measures.end(),
                                 [](const Measure& measure) { return measure.name == kTime; });
  std::vector<Observed> times;
  if (time == measures.end() || !findings.cells[cell].goals) {
    return times;
  }
  const auto place = static_cast<std::size_t>(time - measures.begin());
  double longest = 0.0;
  for (const std::size_t at : findings.cells[cell].runs) {
    const Run& run = findings.results.runs[at];
    const auto& value = run.values[place];
    if (run.state == RunState::done && value && is_usable(*value)) {
      times.push_back({*value, !run.success()});
      longest = std::max(longest, *value);
    }
  }
  for (Observed& one : times) {
    one.value = one.bound ? longest : one.value;
  }
  return times;
}

bool any_cut_off(const Findings& findings) {
  for (std::size_t i = 0; i < findings.cells.size(); ++i) {
    const std::vector<Observed> times = times_to_goals(findings, i);
    if (std::any_of(times.begin(), times.end(), [](const Observed& one) { return one.bound; })) {
      return true;
    }
  }
  return false;
}

}  // namespace elsie::report

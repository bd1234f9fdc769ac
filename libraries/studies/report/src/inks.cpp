#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "figures.h"

namespace elsie::report {

Inks choose_inks(const Findings& findings) {
  const Results& results = findings.results;
  Inks inks;
  inks.cells.assign(results.cells.size(), 0);
  for (std::size_t factor = results.factors.size(); factor-- > 0;) {
    std::map<int, std::string> levels;
    for (const CellInfo& cell : results.cells) {
      levels[cell.places[factor]] = cell.levels[factor];
    }
    if (levels.size() < 2 || levels.size() > kColours) {
      continue;
    }
    inks.factor = factor;
    std::map<int, std::size_t> colours;
    for (const auto& [place, label] : levels) {
      colours[place] = inks.levels.size();
      inks.levels.push_back(label);
    }
    for (std::size_t i = 0; i < results.cells.size(); ++i) {
      inks.cells[i] = colours.at(results.cells[i].places[factor]);
    }
    break;
  }
  return inks;
}

void add_behaviors(const ResultsFile& file, const Findings& findings,
                   const std::vector<std::size_t>& cells, Inks& inks) {
  std::map<std::string, double> shares;
  for (const std::size_t cell : cells) {
    for (const Timeline& timeline : file.timelines(findings.results.cells[cell].id)) {
      for (const Timeline::Behavior& behavior : timeline.behaviors) {
        shares[behavior.path] += behavior.share;
      }
    }
  }
  std::vector<std::pair<std::string, double>> sorted(shares.begin(), shares.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  for (auto& [path, share] : sorted) {
    inks.behaviors.push_back(path);
  }
}

std::string Inks::cell_class(std::size_t cell) const { return "c" + std::to_string(cells[cell]); }

std::size_t Inks::behavior_colour(const std::string& path) const {
  const auto found = std::find(behaviors.begin(), behaviors.end(), path);
  const auto place = static_cast<std::size_t>(found - behaviors.begin());
  if (found == behaviors.end() || place >= kColours) {
    return kColours;
  }
  return (std::max<std::size_t>(levels.size(), 1) + place) % kColours;
}

Budget budget_for(std::size_t cells) {
  Budget budget;
  budget.points = std::clamp<std::size_t>(200000 / std::max<std::size_t>(cells, 1), 500, 20000);
  if (cells > 40) {
    budget = {budget.points, 25, 12};
  }
  return budget;
}

std::optional<std::size_t> typical_run(const Findings& findings, std::size_t cell) {
  const CellFindings& found = findings.cells[cell];
  std::map<Outcome, std::vector<std::size_t>> outcomes;  // success is the first key
  for (const std::size_t place : found.runs) {
    const Run& run = findings.results.runs[place];
    if (run.state == RunState::done) {
      outcomes[run.outcome.value_or(Outcome::failure)].push_back(place);
    }
  }
  const auto commonest = std::max_element(
      outcomes.begin(), outcomes.end(),
      [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
  if (commonest == outcomes.end()) {
    return std::nullopt;
  }
  const auto value_of = [&](std::size_t place) {
    const auto value = findings.measures.empty()
                           ? std::nullopt
                           : findings.results.runs[place].values[findings.measures.front()];
    return value && is_usable(*value) ? value : std::nullopt;
  };
  std::vector<double> values;
  for (const std::size_t place : commonest->second) {
    if (const auto value = value_of(place)) {
      values.push_back(*value);
    }
  }
  const auto middle = summary(values);
  const auto is_outlier = [&](std::size_t place) {
    return std::any_of(found.outliers.begin(), found.outliers.end(),
                       [&](const Outlier& outlier) { return outlier.run == place; });
  };
  std::optional<std::size_t> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t place : commonest->second) {
    const auto value = value_of(place);
    if (is_outlier(place) || value.has_value() != middle.has_value()) {
      continue;
    }
    const double off = middle ? std::abs(*value - middle->median) : 0.0;
    if (off < least) {
      least = off;
      nearest = place;
    }
  }
  return nearest;
}

}  // namespace elsie::report

#include <algorithm>
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

void add_behaviors(const ResultsFile& file, const Findings& findings, Inks& inks) {
  std::map<std::string, double> shares;
  for (const CellInfo& cell : findings.results.cells) {
    for (const Timeline& timeline : file.timelines(cell.id)) {
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

std::string Inks::behavior_class(const std::string& path) const {
  const auto found = std::find(behaviors.begin(), behaviors.end(), path);
  const auto place = static_cast<std::size_t>(found - behaviors.begin());
  if (found == behaviors.end() || place >= kColours) {
    return "more";
  }
  const std::size_t first = std::max<std::size_t>(levels.size(), 1);
  return "c" + std::to_string((first + place) % kColours);
}

Budget budget_for(std::size_t cells) {
  Budget budget;
  budget.points = std::clamp<std::size_t>(200000 / std::max<std::size_t>(cells, 1), 500, 20000);
  if (cells > 40) {
    budget = {budget.points, 25, 12, 300};
  }
  return budget;
}

std::optional<std::size_t> typical_run(const Findings& findings, std::size_t cell) {
  const CellFindings& found = findings.cells[cell];
  for (const bool successes : {true, false}) {
    std::vector<std::pair<double, std::size_t>> runs, without_value;
    for (const std::size_t place : found.runs) {
      const Run& run = findings.results.runs[place];
      if (run.state != RunState::done || (successes && !run.success())) {
        continue;
      }
      const auto value =
          findings.measures.empty() ? std::nullopt : run.values[findings.measures.front()];
      (value ? runs : without_value).emplace_back(value.value_or(0.0), place);
    }
    if (runs.empty()) {
      runs = std::move(without_value);
    }
    if (runs.empty()) {
      continue;
    }
    std::sort(runs.begin(), runs.end());
    return runs[(runs.size() - 1) / 2].second;
  }
  return std::nullopt;
}

}  // namespace elsie::report

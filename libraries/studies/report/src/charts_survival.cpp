// Kaplan-Meier curves of the cells.
#include <algorithm>
#include <cmath>
#include <map>

#include "elsie/picture/axis.h"

#include "charts.h"
#include "numbers.h"

namespace elsie::report {

namespace {

constexpr int kRiskTimes = 5;  // about as many columns of numbers at risk

// Cells that differ in the coloured factor only; without one, as many as can be told apart.
std::vector<std::vector<std::size_t>> together(const Findings& findings, const Inks& inks) {
  std::vector<std::vector<std::size_t>> groups;
  std::map<std::vector<std::string>, std::size_t> places;
  std::size_t count = 0;
  for (std::size_t i = 0; i < findings.cells.size(); ++i) {
    if (times_to_goals(findings, i).empty()) {
      continue;
    }
    std::vector<std::string> key;
    if (inks.factor) {
      key = findings.results.cells[i].levels;
      key[*inks.factor].clear();
    } else {
      key = {std::to_string(count++ / kMostLines)};
    }
    const auto [place, is_new] = places.try_emplace(key, groups.size());
    if (is_new) {
      groups.emplace_back();
    }
    groups[place->second].push_back(i);
  }
  return groups;
}

// The levels that the cells of a chart have in common: "0.4, 0.2".
std::string title_of(const Findings& findings, const Inks& inks,
                     const std::vector<std::size_t>& cells) {
  if (!inks.factor) {
    return "";
  }
  std::string title;
  for (const VariedFactor& factor : varied_factors(findings.results)) {
    if (factor.factor != *inks.factor) {
      title += (title.empty() ? "" : ", ") + factor.name + " " +
               factor.levels[factor.of_cell[cells.front()]];
    }
  }
  return files::one_line(title);
}

picture::Series curve_of(const SurvivalCurve& curve) {
  picture::Series series;
  series.joining = picture::Joining::steps;
  series.points.push_back({0.0, 1.0});
  series.spread.push_back({1.0, 1.0});
  for (const SurvivalStep& step : curve.steps) {
    series.points.push_back({step.time, step.survival});
    series.spread.push_back(step.interval);
    if (step.cut_off > 0) {
      series.strokes.push_back({step.time, step.survival});
    }
  }
  return series;
}

}  // namespace

std::vector<Chart> survival_charts(const Findings& findings, const Inks& inks) {
  std::vector<Chart> charts;
  double longest = 0.0;
  for (std::size_t i = 0; i < findings.cells.size(); ++i) {
    for (const Observed& one : times_to_goals(findings, i)) {
      longest = std::max(longest, one.value);
    }
  }
  const picture::Ticks ticks = picture::nice_ticks(0.0, std::max(longest, 1e-9), kRiskTimes);
  for (const std::vector<std::size_t>& cells : together(findings, inks)) {
    picture::LineChart chart;
    chart.title = title_of(findings, inks, cells);
    chart.x = {.label = "time", .unit = "s", .low = 0.0, .high = longest > 0.0 ? longest : 1.0};
    for (const double tick : ticks.at) {
      chart.x.names.push_back({tick, ticks.label(tick)});
    }
    chart.y = {.label = "not there yet", .low = 0.0, .high = 1.0};
    chart.rows_title = "at risk";
    std::string name = "survival";
    for (const std::size_t cell : cells) {
      const SurvivalCurve curve = survival_of(times_to_goals(findings, cell), kConfidence);
      picture::Series series = curve_of(curve);
      const CellInfo& info = findings.results.cells[cell];
      series.name = files::shortened(
          files::one_line(inks.factor ? info.levels[*inks.factor] : info.label), 40);
      if (inks.factor) {
        series.colour = inks.cells[cell];
      }
      picture::NumberRow row{series.name, {}};
      for (const double tick : ticks.at) {
        row.numbers.push_back({tick, std::to_string(curve.at_risk(tick))});
      }
      chart.rows.push_back(std::move(row));
      chart.series.push_back(std::move(series));
    }
    name +=
        "-" + (chart.title.empty() ? std::to_string(charts.size() + 1) : file_part(chart.title));
    const std::string caption =
        "Runs that have not reached their goals yet: their part by Kaplan and Meier, with 95 % "
        "intervals";
    charts.push_back({std::move(name), caption, std::move(chart)});
  }
  return charts;
}

}  // namespace elsie::report

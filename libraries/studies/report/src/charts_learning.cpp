// Curves that plugins report: of learning, and of measures.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "elsie/picture/axis.h"
#include "elsie/picture/plot.h"

#include "charts.h"
#include "figures.h"
#include "numbers.h"

namespace elsie::report {

namespace {

constexpr double kDecades = 2.0;  // curves over more decades get a logarithmic axis
constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::vector<Vector2> usable(std::vector<Vector2> points) {
  for (Vector2& point : points) {
    if (!is_usable(point.x) || !is_usable(point.y)) {
      point = {kInfinite, kInfinite};  // interrupts the curve
    }
  }
  return points;
}

// A logarithmic axis if curves span decades; otherwise one from zero, if no value is below it.
picture::Axis axis_for(const std::vector<picture::Series>& curves) {
  Interval all, positive;
  for (const picture::Series& curve : curves) {
    for (const Vector2& point : curve.points) {
      all.include(point.y);
      positive.include(point.y > 0.0 ? point.y : kInfinite);
    }
  }
  picture::Axis axis;
  axis.logarithmic = all.low >= 0.0 && std::log10(positive.high / positive.low) > kDecades;
  if (!axis.logarithmic && all.low >= 0.0) {
    axis.low = 0.0;
  }
  return axis;
}

// Equal curves are drawn as one.
picture::LineChart chart_of(const std::vector<const Curve*>& curves) {
  picture::LineChart chart;
  chart.naming = picture::Naming::in_titles;
  chart.x.label = files::shortened(curves.front()->x_label, 50);
  std::vector<std::size_t> counts;
  for (const Curve* curve : curves) {
    std::vector<Vector2> points = usable(curve->points);
    const auto same =
        std::find_if(chart.series.begin(), chart.series.end(),
                     [&](const picture::Series& other) { return other.points == points; });
    if (same == chart.series.end()) {
      chart.series.push_back({"run " + std::to_string(curve->run), std::move(points)});
      counts.push_back(1);
    } else {
      same->name = counted(++counts[static_cast<std::size_t>(same - chart.series.begin())], "run");
    }
  }
  chart.y = axis_for(chart.series);
  return chart;
}

// The curves of the sample by robot, plugin and name.
using CurvePanels =
    std::map<std::tuple<std::string, std::string, std::string>, std::vector<const Curve*>>;

CurvePanels panels_of(const Findings& findings, std::size_t cell,
                      const std::vector<Curve>& curves) {
  std::set<std::int64_t> in_sample;
  for (const std::size_t run : findings.cells[cell].runs) {
    in_sample.insert(findings.results.runs[run].id);
  }
  CurvePanels panels;
  for (const Curve& curve : curves) {
    if (in_sample.contains(curve.run) && !curve.points.empty()) {
      panels[{curve.robot, curve.plugin, curve.name}].push_back(&curve);
    }
  }
  return panels;
}

// "Learning of weights of r1, error: mean square error"; of a measure "known, explore.known".
std::string title_of(const std::string& robot, const std::string& plugin, const std::string& name,
                     const Curve& first) {
  if (robot.empty()) return plugin + ", " + name;
  return "Learning of " + plugin + " of " + robot + ", " + name +
         (first.y_label.empty() || first.y_label == name ? "" : ": " + first.y_label);
}

}  // namespace

std::vector<Chart> learning_charts(const Findings& findings, std::size_t cell,
                                   const std::vector<Curve>& curves) {
  std::vector<Chart> charts;
  for (const auto& [what, all] : panels_of(findings, cell, curves)) {
    const auto& [robot, plugin, name] = what;
    picture::LineChart chart = chart_of(all);
    const bool alike = chart.series.size() == 1 && all.size() > 1;
    chart.y.label = files::shortened(files::one_line(all.front()->y_label), 50);
    charts.push_back({"learning-" + std::to_string(cell + 1) + "-" +
                          file_part(robot + "-" + plugin + "-" + name),
                      title_of(robot, plugin, name, *all.front()),
                      std::move(chart),
                      {counted(all.size(), "run") + (alike ? ", all alike" : "")}});
  }
  return charts;
}

}  // namespace elsie::report

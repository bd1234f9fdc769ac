#include "elsie/picture/fuzzy_plot.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "text.h"

namespace elsie::picture {
namespace {

constexpr std::size_t kGridPoints = 81;
constexpr std::size_t kCurvePoints = 401;

void check_range(const std::string& variable, double low, double high) {
  if (std::isfinite(low) && std::isfinite(high) && low < high) return;
  throw std::invalid_argument("The variable '" + clean_text(variable) +
                              "' cannot be drawn over a range from " + number_text(low) + " to " +
                              number_text(high) +
                              ": both must be finite and the first below the second.");
}

// The set's corners within the range, and its degrees at the limits.
std::vector<Vector2> curve_of(const FuzzySet& set, double low, double high) {
  std::vector<Vector2> points;
  const bool starts_inside = !set.points.empty() && set.points.front().x == low;
  const bool ends_inside = !set.points.empty() && set.points.back().x == high;
  if (!starts_inside) points.push_back({low, set.degree(low)});
  for (const FuzzySet::Point& point : set.points) {
    if (point.x >= low && point.x <= high) points.push_back({point.x, point.degree});
  }
  if (!ends_inside) points.push_back({high, set.degree(high)});
  return points;
}

LineChart membership_chart(const MembershipPanel& panel) {
  check_range(panel.variable, panel.low, panel.high);
  LineChart chart;
  chart.x = {"", "", panel.low, panel.high};
  chart.title = with_unit(panel.variable, panel.unit);
  chart.y = {"degree", "", 0.0, 1.0};
  chart.naming = Naming::at_peak;
  for (const auto& [name, set] : panel.terms) {
    chart.series.push_back({name, curve_of(set, panel.low, panel.high), true});
  }
  return chart;
}

Axis axis_of(const SurfaceVariable& variable) {
  return {variable.name, variable.unit, variable.low, variable.high};
}

std::string surface_title(const ControlSurface& surface) {
  std::string title = surface.output.name + " over " + surface.x.name;
  if (surface.y) title += " and " + surface.y->name;
  const char* separator = " at ";
  for (const HeldInput& held : surface.held) {
    title += separator + held.name + " = " + number_text(held.value);
    if (!held.unit.empty()) title += " " + held.unit;
    separator = ", ";
  }
  return title;
}

double sample(const SurfaceVariable& variable, std::size_t index, std::size_t count) {
  return variable.low + (variable.high - variable.low) * static_cast<double>(index) /
                            static_cast<double>(count - 1);
}

Row surface_row(const ControlSurface& surface) {
  check_range(surface.x.name, surface.x.low, surface.x.high);
  check_range(surface.output.name, surface.output.low, surface.output.high);
  if (!surface.value) {
    throw std::invalid_argument("The control surface of '" + clean_text(surface.output.name) +
                                "' has no function to draw.");
  }
  Row row;
  row.title = surface_title(surface);
  if (!surface.y) {
    LineChart chart{"", axis_of(surface.x), axis_of(surface.output), {}};
    Series series;
    for (std::size_t i = 0; i < kCurvePoints; ++i) {
      const double x = sample(surface.x, i, kCurvePoints);
      series.points.push_back({x, surface.value(x, 0.0)});
    }
    chart.series.push_back(std::move(series));
    row.panels.emplace_back(std::move(chart));
    return row;
  }
  check_range(surface.y->name, surface.y->low, surface.y->high);
  Field field{axis_of(surface.x), axis_of(*surface.y), axis_of(surface.output),
              kGridPoints,        kGridPoints,         {}};
  field.values.reserve(kGridPoints * kGridPoints);
  for (std::size_t j = 0; j < kGridPoints; ++j) {
    for (std::size_t i = 0; i < kGridPoints; ++i) {
      field.values.push_back(
          surface.value(sample(surface.x, i, kGridPoints), sample(*surface.y, j, kGridPoints)));
    }
  }
  row.panels.emplace_back(HeatMap{"", field});
  row.panels.emplace_back(Mesh{"", std::move(field)});
  return row;
}

// Up to three side by side, in rows of nearly equal numbers.
void add_membership_rows(const std::vector<MembershipPanel>& variables, Page& page) {
  constexpr std::size_t kMostInRow = 3;
  const std::size_t rows = (variables.size() + kMostInRow - 1) / kMostInRow;
  for (std::size_t row = 0, next = 0; row < rows; ++row) {
    const std::size_t left = variables.size() - next;
    const std::size_t count = (left + rows - row - 1) / (rows - row);
    Row panels;
    panels.aspect = count == 1 ? 0.26 : count == 2 ? 0.38 : 0.5;
    for (std::size_t i = 0; i < count; ++i) {
      panels.panels.emplace_back(membership_chart(variables[next++]));
    }
    page.rows.push_back(std::move(panels));
  }
}

}  // namespace

Page fuzzy_page(const FuzzyPicture& picture) {
  Page page{picture.title, picture.subtitles, {}};
  add_membership_rows(picture.variables, page);
  for (const ControlSurface& surface : picture.surfaces) page.rows.push_back(surface_row(surface));
  return page;
}

void save_fuzzy_picture(const FuzzyPicture& picture, const std::filesystem::path& file,
                        const Size& size) {
  save_page(fuzzy_page(picture), file, size);
}

}  // namespace elsie::picture

// Charts by factor: main effects, two factors together.
#include <algorithm>
#include <cmath>
#include <limits>

#include "charts.h"
#include "numbers.h"

namespace elsie::report {

namespace {

constexpr std::size_t kMostTiles = 24;      // levels on an axis
constexpr std::size_t kMostPoints = 60;     // levels in a chart of one factor
constexpr std::size_t kMostIntervals = 36;  // in a chart of two factors
constexpr std::size_t kNameLength = 40;
constexpr const char* kTilesOfMedians =
    ": median of all runs, as only a bound is known of some; ? where the median is not known";

std::string shown(const std::string& text) {
  return files::shortened(files::one_line(text), kNameLength);
}

picture::Axis axis_of(const VariedFactor& factor) {
  picture::Axis axis;
  axis.label = shown(factor.name);
  if (factor.numeric()) {
    const double low = factor.numbers.front(), high = factor.numbers.back();
    axis.low = low - 0.06 * (high - low);
    axis.high = high + 0.06 * (high - low);
    return axis;
  }
  for (std::size_t i = 0; i < factor.levels.size(); ++i) {
    axis.names.push_back({static_cast<double>(i), shown(factor.levels[i])});
  }
  return axis;
}

double place_of(const VariedFactor& factor, std::size_t level) {
  return factor.numeric() ? factor.numbers[level] : static_cast<double>(level);
}

// A margin as a point with a bar, whose upper end is infinite if it is unknown; without a point if
// all runs were cut off.
void add_point(picture::Series& series, double x, const Margin& margin) {
  series.points.push_back({x, margin.centre.value_or(kUnknown)});
  series.spread.push_back(margin.interval ? *margin.interval
                          : margin.at_least
                              ? Interval{*margin.at_least, std::numeric_limits<double>::infinity()}
                              : Interval{kUnknown, kUnknown});
}

// The axis of the centres of a response.
picture::Axis axis_of(const Response& response, const Balance& balance) {
  picture::Axis axis = axis_of(response);
  axis.label = (balance.medians ? "median " : "") + axis.label;
  return axis;
}

// With an effect of this size, an axis from 0 would hide nothing.
void start_at_zero(picture::Axis& axis, const Interval& range) {
  if (range.low >= 0.0 && range.low < 0.4 * range.high) {
    axis.low = 0.0;
  }
}

std::string number_in_tile(const Margin& margin, const Response& response,
                           std::optional<int> decimals) {
  if (!margin.centre) {
    return margin.cut_off > 0 ? "?" : "";
  }
  if (!response.measure) {
    return fixed_text(100.0 * *margin.centre, 0) + " %";
  }
  return decimals ? fixed_text(*margin.centre, *decimals) : brief(*margin.centre, 3);
}

std::string what_is_shown(const Response& response, const Balance& balance) {
  return (!response.measure ? std::string("rate of all runs")
          : balance.medians ? "median of all runs, as only a bound is known of some"
                            : "mean of the seeds") +
         ", with its 95 % interval";
}

}  // namespace

std::string file_part(const std::string& text) {
  std::string part;
  for (const char c : text) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                       c == '.' || c == '_' || c == '-';
    part += plain ? c : '_';
  }
  return part.substr(0, 60);
}

picture::Axis axis_of(const Response& response) {
  picture::Axis axis;
  axis.label = shown(response.words);
  axis.unit = shown(response.unit);
  if (!response.measure) {
    axis.low = 0.0;
    axis.high = 1.0;
  }
  return axis;
}

std::vector<std::size_t> level_colours(const VariedFactor& factor, const Inks& inks) {
  std::vector<std::size_t> colours;
  for (const std::string& level : factor.levels) {
    const auto found = std::find(inks.levels.begin(), inks.levels.end(), level);
    const bool coloured = inks.factor == factor.factor && found != inks.levels.end();
    colours.push_back(coloured ? static_cast<std::size_t>(found - inks.levels.begin())
                               : picture::kNeutral);
  }
  return colours;
}

std::vector<Chart> effect_charts(const Findings& findings, const Response& response) {
  std::vector<Chart> charts;
  Interval range;
  for (const VariedFactor& factor : varied_factors(findings.results)) {
    if (factor.levels.size() > kMostPoints) {
      continue;
    }
    const Balance balance = balanced(findings, response, factor.groups(), {factor.factor});
    picture::LineChart chart;
    chart.x = axis_of(factor);
    chart.y = axis_of(response, balance);
    picture::Series series;
    series.marked = series.bars = true;
    series.joining = factor.numeric() ? picture::Joining::lines : picture::Joining::nothing;
    series.colour = picture::kNeutral;
    for (std::size_t i = 0; i < factor.levels.size(); ++i) {
      const Margin margin = margin_of(findings, response, balance, i);
      add_point(series, place_of(factor, i), margin);
      range.include(series.points.back().y);
      range.include(series.spread.back().low);
      range.include(series.spread.back().high);
    }
    chart.series.push_back(std::move(series));
    charts.push_back({"effect-" + file_part(response.name) + "-" + file_part(factor.name),
                      response.words + " by " + factor.name +
                          ", over all else: " + what_is_shown(response, balance),
                      std::move(chart), notes_on(balance)});
  }
  if (range.empty()) {
    return {};
  }
  for (Chart& one : charts) {
    auto& chart = std::get<picture::LineChart>(one.panel);
    if (!response.measure) {
      continue;
    }
    const Interval wide = range.widened();
    const double extra = 0.05 * wide.span();
    chart.y.low = wide.low - extra;
    chart.y.high = wide.high + extra;
    start_at_zero(chart.y, range);
  }
  return charts;
}

std::vector<Chart> pair_charts(const Findings& findings, const Response& response,
                               const Inks& inks) {
  std::vector<Chart> charts;
  const std::vector<VariedFactor> factors = varied_factors(findings.results);
  for (std::size_t i = 0; i < factors.size(); ++i) {
    for (std::size_t j = i + 1; j < factors.size(); ++j) {
      // Lines are the levels of the coloured factor, or of the one with fewer levels. Tiles alone
      // have the longer list of names where each name has a row of its own.
      const std::size_t first = factors[i].levels.size(), second = factors[j].levels.size();
      const bool swap = std::min(first, second) > kMostLines
                            ? first > second
                            : inks.factor == factors[i].factor ||
                                  (inks.factor != factors[j].factor && first < second);
      const VariedFactor& along = factors[swap ? j : i];
      const VariedFactor& lines = factors[swap ? i : j];
      const std::size_t columns = along.levels.size(), rows = lines.levels.size();
      if (columns > kMostTiles || rows > kMostTiles) {
        continue;
      }
      std::vector<std::vector<std::size_t>> groups;
      for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
          groups.push_back(common(along.cells_at(column), lines.cells_at(row)));
        }
      }
      const Balance balance = balanced(findings, response, groups, {along.factor, lines.factor});
      picture::LineChart chart;
      chart.x = axis_of(along);
      chart.y = axis_of(response, balance);
      picture::Tiles tiles;
      tiles.x = {.label = shown(along.name)};
      tiles.y = {.label = shown(lines.name)};
      tiles.z = axis_of(response, balance);
      for (const std::string& level : along.levels) tiles.x.names.push_back({0.0, shown(level)});
      for (std::size_t column = 0; column < columns; ++column) {
        tiles.x.names[column].at = place_of(along, column);
      }
      const std::vector<std::size_t> colours = level_colours(lines, inks);
      Interval range, values, bars;
      std::vector<Margin> margins;
      for (std::size_t row = 0; row < rows; ++row) {
        tiles.y.names.push_back({place_of(lines, row), shown(lines.levels[row])});
        picture::Series series;
        series.name = shown(lines.levels[row]);
        series.marked = true;
        series.bars = true;
        series.colour = colours[row];
        for (std::size_t column = 0; column < columns; ++column) {
          const Margin margin = margin_of(findings, response, balance, row * columns + column,
                                          columns * rows <= kMostIntervals);
          // Lines stand a little apart, so that their bars do not hide each other.
          const double step =
              along.numeric() ? (along.numbers.back() - along.numbers.front()) / 60.0 : 0.06;
          const double aside =
              step * (static_cast<double>(row) - 0.5 * static_cast<double>(rows - 1));
          add_point(series, place_of(along, column) + aside, margin);
          range.include(series.points.back().y);
          bars.include(series.spread.back().low);
          tiles.values.push_back(margin.centre.value_or(kUnknown));
          values.include(tiles.values.back());
          margins.push_back(margin);
        }
        chart.series.push_back(std::move(series));
      }
      if (range.empty() && bars.empty()) {
        continue;
      }
      // Decimals that tell the tiles apart.
      const auto decimals =
          values.empty() ? std::nullopt : decimals_for(values.high, values.span());
      for (const Margin& margin : margins) {
        tiles.texts.push_back(number_in_tile(margin, response, decimals));
      }
      const std::string name =
          file_part(response.name) + "-" + file_part(along.name) + "-" + file_part(lines.name);
      const std::string words = response.words + " by " + along.name + " and " + lines.name;
      if (rows <= kMostLines) {
        if (response.measure && !range.empty()) {
          start_at_zero(chart.y, range);
        }
        charts.push_back({"interaction-" + name, words + ": " + what_is_shown(response, balance),
                          std::move(chart), notes_on(balance)});
      }
      if (values.empty()) {
        continue;  // a "?" in each tile
      }
      charts.push_back({"tiles-" + name, words + (balance.medians ? kTilesOfMedians : ""),
                        std::move(tiles), notes_on(balance)});
    }
  }
  return charts;
}

}  // namespace elsie::report

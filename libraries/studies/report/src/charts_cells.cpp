// Charts of cells below each other: box plots, rates of success.
#include <algorithm>

#include "charts.h"
#include "numbers.h"
#include "words.h"

namespace elsie::report {

namespace {

// With more dots than this in all charts, they have no titles.
constexpr std::size_t kDotsWithTitles = 6000;
// With more, only crosses and outliers are drawn.
constexpr std::size_t kDots = 30000;

// "-3" for the third of several parts of a figure.
std::string part_of(const Findings& findings, std::size_t from, std::size_t to) {
  return from == 0 && to == findings.cells.size()
             ? ""
             : "-" + std::to_string(from + 1) + "-" + std::to_string(to);
}

}  // namespace

std::string row_name(const Findings& findings, std::size_t cell) {
  const std::string& label = findings.results.cells[cell].label;
  return short_label(label.empty() ? "all" : label, 46);
}

Chart box_chart(const Findings& findings, std::size_t measure, const Inks& inks, std::size_t from,
                std::size_t to) {
  const Measure& about = findings.results.measures[findings.measures[measure]];
  const std::size_t dots = findings.runs() * findings.measures.size();
  Interval range;
  picture::RowChart chart;
  chart.x = {.label = files::one_line(in_words(about.name, about.unit)),
             .unit = files::one_line(about.unit)};
  for (std::size_t i = from; i < to; ++i) {
    const CellFindings& cell = findings.cells[i];
    const MeasureFindings& found = cell.measures[measure];
    picture::ChartRow row{.name = row_name(findings, i), .colour = inks.cells[i]};
    for (const std::size_t place : cell.runs) {
      const Run& run = findings.results.runs[place];
      const auto& value = run.values[findings.measures[measure]];
      if (run.state != RunState::done || !value || !is_usable(*value)) {
        continue;
      }
      range.include(*value);
      const bool missed = findings.missed(run), outlier = found.stands_out(*value);
      if (dots > kDots && !missed && !outlier) {
        continue;
      }
      row.dots.push_back({*value, missed, outlier});
      if (dots <= kDotsWithTitles) {
        row.dots.back().title =
            name_of(run) + ": " + brief(*value, 6) + (about.unit.empty() ? "" : " " + about.unit) +
            (missed ? ", " + outcome_in_words(run) : "") + (outlier ? ", outlier" : "");
      }
    }
    if (!found.all && !found.censoring) {
      row.note = "no value";
    }
    if (found.all && found.values.size() >= kFewest) {
      std::vector<double> sorted = found.values;
      std::sort(sorted.begin(), sorted.end());
      row.box = picture::RowBox{whiskers(sorted, *found.fences),
                                {found.all->lower_quartile, found.all->upper_quartile},
                                found.all->median};
    }
    if (found.all) {
      row.mark = found.all->mean;
    }
    if (found.interval) range.include(found.interval->low);
    row.interval = found.interval;
    chart.rows.push_back(std::move(row));
  }
  if (range.low > 0.0 && range.low < 0.4 * range.high) {
    chart.x.low = 0.0;  // it is near; dots at 0 keep off the edge
  }
  return {"boxes-" + file_part(about.name) + part_of(findings, from, to),
          "Box plots of " + in_words(about.name, about.unit) +
              ": dots are runs, crosses those "
              "without success, rings outliers, diamonds means with their 95 % intervals",
          std::move(chart),
          dots > kDots ? std::vector<std::string>{"Only crosses and rings are drawn of the runs"}
                       : std::vector<std::string>()};
}

Chart rate_chart(const Findings& findings, const Inks& inks, std::size_t from, std::size_t to) {
  picture::RowChart chart;
  chart.x = {.label = "rate of success", .low = 0.0, .high = 1.0};
  for (std::size_t i = from; i < to; ++i) {
    const CellFindings& cell = findings.cells[i];
    if (!cell.goals) {
      continue;
    }
    picture::ChartRow row{.name = row_name(findings, i), .colour = inks.cells[i]};
    row.note = success_in_words(cell) +
               (cell.complete() ? "" : ", " + std::to_string(cell.pending) + " to do");
    if (cell.ended > 0) {
      row.mark = static_cast<double>(cell.successes) / static_cast<double>(cell.ended);
      row.interval = cell.success;
    }
    chart.rows.push_back(std::move(row));
  }
  return {"success" + part_of(findings, from, to), "Rates of success with Wilson's 95 % intervals",
          std::move(chart)};
}

}  // namespace elsie::report

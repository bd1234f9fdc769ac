// Charts of cells below each other: box plots, rates of success, who decided when.
#include <algorithm>
#include <map>

#include "charts.h"
#include "numbers.h"

namespace elsie::report {

namespace {

std::string row_name(const Findings& findings, std::size_t cell) {
  const std::string& label = findings.results.cells[cell].label;
  return output::shortened(output::one_line(label.empty() ? "all" : label), 46);
}

// "-3" for the third of several parts of a figure.
std::string part_of(const Findings& findings, std::size_t from, std::size_t to) {
  return from == 0 && to == findings.cells.size()
             ? ""
             : "-" + std::to_string(from + 1) + "-" + std::to_string(to);
}

// An episode as bars: its decider, or the parts of several one after the other.
void add_bars(const Timeline::Episode& episode, const Inks& inks, picture::ChartRow& row) {
  const auto colour_of = [&](const std::string& path) {
    const std::string name = inks.behavior_class(path);
    return name == "more" ? kColours : static_cast<std::size_t>(name[1] - '0');
  };
  if (episode.parts.empty()) {
    if (!episode.decider.empty()) {
      row.bars.push_back({{episode.from_s, episode.to_s}, colour_of(episode.decider)});
    }
    return;
  }
  double from = episode.from_s;
  for (const auto& [who, time_s] : episode.parts) {
    const double to = std::min(episode.to_s, from + time_s);
    if (!who.empty() && to > from) {
      row.bars.push_back({{from, to}, colour_of(who)});
    }
    from = to;
  }
}

}  // namespace

Chart box_chart(const Findings& findings, std::size_t measure, const Inks& inks, std::size_t from,
                std::size_t to) {
  const Measure& about = findings.results.measures[findings.measures[measure]];
  picture::RowChart chart;
  chart.x = {.label = output::one_line(in_words(about.name, about.unit)),
             .unit = output::one_line(about.unit)};
  for (std::size_t i = from; i < to; ++i) {
    const CellFindings& cell = findings.cells[i];
    const MeasureFindings& found = cell.measures[measure];
    picture::ChartRow row{.name = row_name(findings, i), .colour = inks.cells[i]};
    for (const std::size_t place : cell.runs) {
      const Run& run = findings.results.runs[place];
      const auto& value = run.values[findings.measures[measure]];
      if (run.state == RunState::done && value && is_usable(*value)) {
        (findings.missed(run) ? row.crosses : row.dots).push_back(*value);
      }
    }
    if (found.all && found.values.size() >= kFewest) {
      std::vector<double> sorted = found.values;
      std::sort(sorted.begin(), sorted.end());
      const Interval ends = whiskers(sorted, *found.fences);
      row.box = picture::RowBox{{ends.low, ends.high},
                                {found.all->lower_quartile, found.all->upper_quartile},
                                found.all->median};
    }
    if (found.all) {
      row.mark = found.all->mean;
    }
    if (found.interval) {
      row.interval = picture::Interval{found.interval->low, found.interval->high};
    }
    chart.rows.push_back(std::move(row));
  }
  return {"boxes-" + file_part(about.name) + part_of(findings, from, to),
          "Box plots of " + in_words(about.name, about.unit) +
              ": dots are runs, crosses those "
              "without success, diamonds means with their 95 % intervals",
          std::move(chart)};
}

Chart rate_chart(const Findings& findings, const Inks& inks, std::size_t from, std::size_t to) {
  picture::RowChart chart;
  chart.x = {.label = "rate of success", .low = 0.0, .high = 1.0};
  for (std::size_t i = from; i < to; ++i) {
    const CellFindings& cell = findings.cells[i];
    if (!cell.goals || cell.ended == 0) {
      continue;
    }
    picture::ChartRow row{.name = row_name(findings, i), .colour = inks.cells[i]};
    row.mark = static_cast<double>(cell.successes) / static_cast<double>(cell.ended);
    row.interval = picture::Interval{cell.success.low, cell.success.high};
    chart.rows.push_back(std::move(row));
  }
  return {"success" + part_of(findings, from, to), "Rates of success with Wilson's 95 % intervals",
          std::move(chart)};
}

std::vector<Chart> decision_charts(const Findings& findings, std::size_t cell,
                                   const std::vector<Timeline>& timelines, const Inks& inks) {
  std::map<std::string, std::size_t> robots;
  for (const Timeline& timeline : timelines) {
    ++robots[timeline.robot];
  }
  picture::RowChart chart;
  chart.x = {.label = "time", .unit = "s", .low = 0.0};
  const auto typical = typical_run(findings, cell);
  for (const std::size_t place : findings.cells[cell].runs) {
    const Run& run = findings.results.runs[place];
    for (const Timeline& timeline : timelines) {
      if (timeline.run != run.id || (robots.size() > 1 && place != typical)) {
        continue;
      }
      picture::ChartRow row{.name = robots.size() > 1 ? output::one_line(timeline.robot)
                                                      : "seed " + std::to_string(run.seed)};
      for (const Timeline::Episode& episode : timeline.episodes) {
        add_bars(episode, inks, row);
      }
      chart.rows.push_back(std::move(row));
    }
  }
  if (chart.rows.empty()) {
    return {};
  }
  for (const std::string& path : inks.behaviors) {
    const std::string name = inks.behavior_class(path);
    if (name != "more") {
      chart.key.emplace_back(output::one_line(path), static_cast<std::size_t>(name[1] - '0'));
    }
  }
  return {{"decisions-" + std::to_string(cell + 1),
           "Who decided when in " +
               (robots.size() > 1 ? std::string("a typical run") : std::string("each run")) +
               " of " + row_name(findings, cell),
           std::move(chart)}};
}

}  // namespace elsie::report

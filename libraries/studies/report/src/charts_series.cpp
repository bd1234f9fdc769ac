// What happened over time, over runs: distance driven, and events.
#include <algorithm>
#include <cmath>
#include <map>

#include "charts.h"
#include "numbers.h"

namespace elsie::report {

namespace {

constexpr std::size_t kTimes = 41;      // points of a curve
constexpr std::size_t kMostEvents = 3;  // kinds of events that are drawn, the commonest first

// One run: a quantity at equal steps of time; it keeps its last value when the run is over.
using Course = std::vector<double>;

struct Courses {
  std::string name;  // "distance driven", "collected so far"
  std::string unit;
  std::map<std::size_t, Course> of_run;  // by index of the run
};

struct Times {
  double end_s = 0.0;
  double at(std::size_t i) const {
    return end_s * static_cast<double>(i) / static_cast<double>(kTimes - 1);
  }
};

// Adds how far a robot had come at each time.
void add_way(const Trajectory& way, double end_s, const Times& times, Course& course) {
  double length = 0.0;
  std::size_t next = 1;
  const auto time_of = [&](std::size_t pose) {
    const double time = way.from_s + way.period_s * static_cast<double>(pose);
    return pose + 1 == way.poses.size() ? std::max(end_s, way.from_s) : time;
  };
  for (std::size_t i = 0; i < kTimes; ++i) {
    for (; next < way.poses.size() && time_of(next) <= times.at(i) + 1e-9; ++next) {
      const double step = std::hypot(way.poses[next].x - way.poses[next - 1].x,
                                     way.poses[next].y - way.poses[next - 1].y);
      length += is_usable(step) ? step : 0.0;
    }
    course[i] += length;
  }
}

Times times_of(const Findings& findings) {
  Times times;
  for (const Run& run : findings.results.runs) {
    times.end_s = std::max(times.end_s, run.simulated_s.value_or(0.0));
  }
  return times;
}

std::vector<Courses> read_courses(const Findings& findings, const ResultsFile& file,
                                  const Times& times) {
  const Results& results = findings.results;
  Courses distance{"distance driven", "m", {}};
  std::map<std::string, Courses> events;
  std::map<std::string, std::size_t> counts;
  for (std::size_t cell = 0; cell < results.cells.size(); ++cell) {
    std::map<std::int64_t, std::size_t> sample;
    for (const std::size_t place : findings.cells[cell].runs) {
      if (results.runs[place].state == RunState::done) {
        sample[results.runs[place].id] = place;
      }
    }
    for (const Trajectory& way : file.trajectories(results.cells[cell].id)) {
      if (const auto run = sample.find(way.run); run != sample.end() && !way.poses.empty()) {
        Course& course =
            distance.of_run.try_emplace(run->second, Course(kTimes, 0.0)).first->second;
        add_way(way, results.runs[run->second].simulated_s.value_or(0.0), times, course);
      }
    }
    for (const Event& event : file.events(results.cells[cell].id)) {
      if (const auto run = sample.find(event.run); run != sample.end()) {
        Courses& courses = events[event.name];
        Course& course = courses.of_run.try_emplace(run->second, Course(kTimes, 0.0)).first->second;
        for (std::size_t i = 0; i < kTimes; ++i) {
          course[i] += event.time_s <= times.at(i) ? 1.0 : 0.0;
        }
        ++counts[event.name];
      }
    }
  }
  std::vector<Courses> all;
  if (!distance.of_run.empty()) {
    all.push_back(std::move(distance));
  }
  std::vector<std::string> names;
  for (const auto& [name, count] : counts) {
    names.push_back(name);
  }
  std::stable_sort(names.begin(), names.end(),
                   [&](const auto& a, const auto& b) { return counts.at(a) > counts.at(b); });
  names.resize(std::min(names.size(), kMostEvents));
  for (const std::string& name : names) {
    Courses& courses = events.at(name);
    courses.name = "events '" + files::one_line(name) + "' so far";
    for (const CellFindings& cell : findings.cells) {  // runs without any such event
      for (const std::size_t place : cell.runs) {
        if (results.runs[place].state == RunState::done) {
          courses.of_run.try_emplace(place, Course(kTimes, 0.0));
        }
      }
    }
    all.push_back(std::move(courses));
  }
  return all;
}

picture::Series band_of(const Courses& courses, const Findings& findings, const Times& times,
                        const std::vector<std::size_t>& cells) {
  picture::Series series;
  for (std::size_t i = 0; i < kTimes; ++i) {
    std::vector<double> values;
    for (const std::size_t cell : cells) {
      for (const std::size_t run : findings.cells[cell].runs) {
        if (const auto course = courses.of_run.find(run); course != courses.of_run.end()) {
          values.push_back(course->second[i]);
        }
      }
    }
    if (const auto all = summary(values)) {
      series.points.push_back({times.at(i), all->median});
      series.spread.push_back({all->lower_quartile, all->upper_quartile});
    }
  }
  return series;
}

}  // namespace

std::vector<Chart> series_charts(const Findings& findings, const ResultsFile& file,
                                 const Inks& inks) {
  std::vector<Chart> charts;
  const Times times = times_of(findings);
  if (times.end_s <= 0.0) {
    return charts;
  }
  std::vector<VariedFactor> factors = varied_factors(findings.results);
  std::erase_if(factors, [](const auto& factor) { return factor.levels.size() > kMostLines; });
  for (const Courses& courses : read_courses(findings, file, times)) {
    const auto add = [&](const std::string& by, std::vector<picture::Series> series) {
      picture::LineChart chart;
      chart.title = files::one_line(by);
      chart.x = {.label = "time", .unit = "s", .low = 0.0, .high = times.end_s};
      chart.y = {.label = courses.name, .unit = courses.unit, .low = 0.0};
      std::erase_if(series, [](const auto& one) { return one.points.empty(); });
      chart.series = std::move(series);
      charts.push_back(
          {"series-" + file_part(courses.name) + (by.empty() ? "" : "-" + file_part(by)),
           courses.name + " over time" + (by.empty() ? "" : ", by " + by) +
               ": median and quartiles of the runs",
           std::move(chart)});
    };
    // Rare events, which most runs have none of, are no curve.
    const picture::Series whole = band_of(courses, findings, times, all_cells(findings));
    if (whole.spread.empty() || whole.spread.back().high == 0.0) {
      continue;
    }
    for (const VariedFactor& factor : factors) {
      std::vector<picture::Series> all;
      const std::vector<std::size_t> colours = level_colours(factor, inks);
      for (std::size_t level = 0; level < factor.levels.size(); ++level) {
        picture::Series series = band_of(courses, findings, times, factor.cells_at(level));
        series.name = files::shortened(files::one_line(factor.levels[level]), 40);
        series.colour = colours[level];
        all.push_back(std::move(series));
      }
      add(factor.name, std::move(all));
    }
    if (factors.empty()) {
      add("", {whole});
    }
  }
  return charts;
}

}  // namespace elsie::report

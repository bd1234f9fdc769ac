// Who decided when: a row for each run, in the colours of the behaviours.
#include <algorithm>
#include <map>

#include "charts.h"
#include "numbers.h"
#include "words.h"

namespace elsie::report {

namespace {

struct Row {
  const Run* run = nullptr;
  const Timeline* timeline = nullptr;
};

// With one robot, a row for each run; with several, a row for each robot in a typical run.
std::vector<Row> rows_of(const Findings& findings, std::size_t cell,
                         const std::vector<Timeline>& timelines, bool several) {
  const auto typical = several ? typical_run(findings, cell) : std::nullopt;
  std::vector<Row> rows;
  for (const std::size_t place : findings.cells[cell].runs) {
    if (typical.value_or(place) != place || (several && !rows.empty())) {
      continue;
    }
    const Run& run = findings.results.runs[place];
    for (const Timeline& timeline : timelines) {
      if (timeline.run == run.id && !timeline.episodes.empty()) {
        rows.push_back({&run, &timeline});
      }
    }
  }
  return rows;
}

// An episode as bars: its decider, or several above each other in proportion to their times, the
// longest at the bottom.
void add_bars(const Timeline::Episode& episode, const Inks& inks, picture::ChartRow& row) {
  std::vector<std::pair<std::string, double>> parts = episode.parts;
  if (parts.empty()) {
    parts = {{episode.decider, 1.0}};
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  double all = 0.0, done = 0.0;
  for (const auto& [who, time] : parts) {
    all += time;
  }
  for (const auto& [who, time] : parts) {
    const Interval height{done / all, (done + time) / all};
    done += time;
    if (!who.empty() && time > 0.0) {
      row.bars.push_back({{episode.from_s, episode.to_s}, inks.behavior_colour(who), height});
    }
  }
}

struct Mean {
  double share = 0.0;    // in the command
  double decided = 0.0;  // part of the time
  double count = 0.0;
};

// "avoid 61 %, share 0.57" with its colour, in descending order of the shares.
std::vector<std::pair<std::string, std::size_t>> key_of(const std::vector<Row>& rows,
                                                        const Inks& inks) {
  std::map<std::string, Mean> means;
  for (const Row& row : rows) {
    const auto& episodes = row.timeline->episodes;
    const double length = episodes.back().to_s - episodes.front().from_s;
    for (const Timeline::Behavior& behavior : row.timeline->behaviors) {
      Mean& mean = means[behavior.path];
      mean.count += 1.0;
      mean.share += (behavior.share - mean.share) / mean.count;
      mean.decided +=
          ((length > 0.0 ? behavior.decided_s / length : 0.0) - mean.decided) / mean.count;
    }
  }
  std::vector<std::pair<std::string, Mean>> sorted(means.begin(), means.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second.share > b.second.share; });
  std::vector<std::pair<std::string, std::size_t>> key;
  for (const auto& [path, mean] : sorted) {
    key.emplace_back(files::shortened(files::one_line(path), 40) + " " +
                         fixed_text(100.0 * mean.decided, 0) + " %, share " +
                         fixed_text(mean.share, 2),
                     inks.behavior_colour(path));
  }
  return key;
}

}  // namespace

std::vector<Chart> decision_charts(const Findings& findings, std::size_t cell,
                                   const std::vector<Timeline>& timelines, const Inks& inks,
                                   std::size_t most) {
  const bool several = std::any_of(
      timelines.begin(), timelines.end(),
      [&](const Timeline& timeline) { return timeline.robot != timelines.front().robot; });
  const std::vector<Row> all = rows_of(findings, cell, timelines, several);
  const std::size_t count = std::min(all.size(), most);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < count; ++i) {
    rows.push_back(all[several ? i : i * all.size() / count]);
  }
  picture::RowChart chart;
  double end_s = 0.0;
  for (const Row& row : rows) {
    picture::ChartRow& drawn = chart.rows.emplace_back();
    drawn.name = several ? files::shortened(files::one_line(row.timeline->robot), 12)
                         : "seed " + std::to_string(row.run->seed);
    drawn.note = findings.missed(*row.run) ? outcome_in_words(*row.run) : "";
    for (const Timeline::Episode& episode : row.timeline->episodes) {
      add_bars(episode, inks, drawn);
    }
    end_s = std::max(end_s, row.timeline->episodes.back().to_s);
  }
  if (!(end_s > 0.0)) {
    return {};
  }
  chart.x = {.label = "time", .unit = "s", .low = 0.0, .high = end_s};
  chart.key = key_of(rows, inks);
  const std::string note =
      several
          ? name_of(*rows.front().run) + (typical_run(findings, cell) ? ", a typical one" : "") +
                (count < all.size()
                     ? ", " + std::to_string(count) + " of " + counted(all.size(), "robot")
                     : "")
      : count < all.size() ? std::to_string(count) + " of " + counted(all.size(), "run")
                           : "every run";
  return {{"decisions-" + std::to_string(cell + 1),
           "Who decided when: " + row_name(findings, cell),
           std::move(chart),
           {note}}};
}

}  // namespace elsie::report

// Which behaviour decided when: a row for each run, in the colours of the behaviours.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "figures.h"
#include "markup.h"
#include "numbers.h"

namespace elsie::report {

namespace {

constexpr int kRow = 12;  // height of a row with a gap of two
constexpr int kBar = kRow - 2;
// If there are only few rows, they are drawn higher.
constexpr double kHighestRow = 24.0, kEnoughHeight = 240.0;
constexpr const char* kNobody = "";

using Times = std::map<std::string, double>;  // of deciders, s

// The deciding behaviours of each column of a row, with their times in s.
std::vector<Times> columns_of(const Timeline& timeline, double end_s, int count) {
  std::vector<Times> columns(static_cast<std::size_t>(count));
  const double width = end_s / count;
  const auto add = [&](const std::string& who, double from, double to, double part) {
    const int first = std::clamp(static_cast<int>(from / width), 0, count - 1);
    const int last = std::clamp(static_cast<int>(to / width), 0, count - 1);
    for (int i = first; i <= last; ++i) {
      const double inside = std::min(to, (i + 1) * width) - std::max(from, i * width);
      if (inside > 0.0) {
        columns[static_cast<std::size_t>(i)][who] += part * inside;
      }
    }
  };
  for (const Timeline::Episode& episode : timeline.episodes) {
    if (!(episode.to_s > episode.from_s)) {
      continue;
    }
    if (episode.parts.empty()) {
      add(episode.decider, episode.from_s, episode.to_s, 1.0);
      continue;
    }
    for (const auto& [who, time_s] : episode.parts) {
      add(who, episode.from_s, episode.to_s,
          std::min(1.0, time_s / (episode.to_s - episode.from_s)));
    }
  }
  return columns;
}

// The bars of each decider as path data: lines as thick as a row, and rectangles in columns with
// several deciders. These are divided in proportion, the longest at the bottom.
struct Bar {
  std::string whole, parts;
};
using Bars = std::map<std::string, Bar>;

struct Cut {
  std::string who;
  int from = 0, to = 0;  // parts of kBar
  friend bool operator==(const Cut&, const Cut&) = default;
};

std::vector<Cut> cuts_of(const Times& times) {
  std::vector<std::pair<double, std::string>> sorted;
  double sum = 0.0;
  for (const auto& [who, time] : times) {
    sorted.emplace_back(-time, who);
    sum += time;
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<Cut> cuts;
  double done = 0.0;
  for (const auto& [minus, who] : sorted) {
    const int from = static_cast<int>(std::lround(kBar * done / sum));
    done -= minus;
    const int to = static_cast<int>(std::lround(kBar * done / sum));
    if (to > from) {
      cuts.push_back({who, kBar - to, kBar - from});
    }
  }
  return cuts;
}

void add_row(const Timeline& timeline, double end_s, int count, int top, Bars& bars) {
  const std::vector<Times> columns = columns_of(timeline, end_s, count);
  std::vector<Cut> open;
  int since = 0;
  for (int i = 0; i <= count; ++i) {
    const std::vector<Cut> cuts =
        i < count ? cuts_of(columns[static_cast<std::size_t>(i)]) : std::vector<Cut>();
    if (cuts == open) {
      continue;
    }
    for (const Cut& cut : open) {
      if (cut.who == kNobody) {
        continue;
      }
      const std::string from = "M" + std::to_string(since) + ' ';
      const std::string width = std::to_string(i - since);
      if (cut.to - cut.from == kBar) {
        bars[cut.who].whole += from + std::to_string(top + kBar / 2) + 'h' + width;
      } else {
        bars[cut.who].parts += from + std::to_string(top + cut.from) + 'h' + width + 'v' +
                               std::to_string(cut.to - cut.from) + "h-" + width + 'z';
      }
    }
    open = cuts;
    since = i;
  }
}

struct Row {
  std::string label;
  const Timeline* timeline = nullptr;
  bool missed = false;
};

const Run* run_of(const Findings& findings, std::int64_t id) {
  const auto& runs = findings.results.runs;
  const auto found = std::lower_bound(runs.begin(), runs.end(), id,
                                      [](const Run& run, std::int64_t at) { return run.id < at; });
  return found != runs.end() && found->id == id ? &*found : nullptr;
}

// With one robot, a row for each run; with several, a row for each robot in a typical run.
std::vector<Row> rows_of(const Findings& findings, std::size_t cell,
                         const std::vector<Timeline>& timelines, std::size_t most,
                         std::string& about) {
  std::map<std::string, std::size_t> robots;
  for (const Timeline& timeline : timelines) {
    ++robots[timeline.robot];
  }
  std::vector<Row> rows;
  if (robots.size() == 1) {
    std::vector<Row> all;
    for (const std::size_t place : findings.cells[cell].runs) {
      const Run& run = findings.results.runs[place];
      for (const Timeline& timeline : timelines) {
        if (timeline.run != run.id) {
          continue;
        }
        all.push_back({"seed " + std::to_string(run.seed), &timeline, findings.missed(run)});
      }
    }
    const std::size_t count = std::min(all.size(), most);
    for (std::size_t i = 0; i < count; ++i) {
      rows.push_back(all[i * all.size() / count]);
    }
    about = count < all.size() ? std::to_string(count) + " of " + counted(all.size(), "run")
                               : "every run";
    return rows;
  }
  const std::optional<std::size_t> typical = typical_run(findings, cell);
  const std::int64_t id = typical             ? findings.results.runs[*typical].id
                          : timelines.empty() ? 0
                                              : timelines.front().run;
  for (const Timeline& timeline : timelines) {
    if (timeline.run == id && rows.size() < most) {
      rows.push_back({timeline.robot, &timeline, false});
    }
  }
  const Run* run = run_of(findings, id);
  about = "run " + std::to_string(id) + (run ? ", seed " + std::to_string(run->seed) : "") +
          (typical ? ", a typical one" : "");
  return rows;
}

struct Mean {
  double share = 0.0;
  double decided = 0.0;  // share of the time
  std::size_t count = 0;
};

// The legend of the behaviours: colour, name, mean share in the command.
std::string key(const std::vector<Row>& rows, const Inks& inks) {
  std::map<std::string, Mean> means;
  for (const Row& row : rows) {
    const auto& episodes = row.timeline->episodes;
    const double length = episodes.empty() ? 0.0 : episodes.back().to_s - episodes.front().from_s;
    for (const Timeline::Behavior& behavior : row.timeline->behaviors) {
      Mean& mean = means[behavior.path];
      mean.share += behavior.share;
      mean.decided += length > 0.0 ? behavior.decided_s / length : 0.0;
      ++mean.count;
    }
  }
  std::vector<std::pair<double, std::string>> sorted;
  for (const auto& [path, mean] : means) {
    sorted.emplace_back(-mean.share / static_cast<double>(mean.count), path);
  }
  std::sort(sorted.begin(), sorted.end());
  std::string text = "<ul class=\"key\">";
  for (const auto& [minus, path] : sorted) {
    const Mean& mean = means[path];
    const auto count = static_cast<double>(mean.count);
    text += "<li><i class=\"swatch " + inks.behavior_class(path) + "\"></i>" +
            escaped(output::shortened(path, 40)) + " <b>" +
            fixed_text(100.0 * mean.decided / count, 0) + " %</b> <small>share " +
            fixed_text(mean.share / count, 2) + "</small></li>";
  }
  return text + "</ul>";
}

}  // namespace

std::string decision_figure(const Findings& findings, std::size_t cell,
                            const std::vector<Timeline>& timelines, const Inks& inks,
                            const Budget& budget) {
  std::string about;
  std::vector<Row> rows = rows_of(findings, cell, timelines, budget.rows, about);
  std::erase_if(rows, [](const Row& row) { return row.timeline->episodes.empty(); });
  double end_s = 0.0;
  for (const Row& row : rows) {
    end_s = std::max(end_s, row.timeline->episodes.back().to_s);
  }
  if (!(end_s > 0.0)) {
    return "";
  }
  Bars bars;
  std::string labels, ends;
  int top = 0;
  const double scale =
      std::clamp(kEnoughHeight / static_cast<double>(rows.size()), double{kRow}, kHighestRow) /
      kRow;
  for (const Row& row : rows) {
    add_row(*row.timeline, end_s, budget.columns, top, bars);
    labels += "<text y=\"" + fixed_text(scale * (top + 0.5 * kBar) + 4.0, 1) + "\"" +
              (row.missed ? " class=\"missed\"" : "") + ">" +
              escaped(output::shortened(row.label, 12)) + "</text>";
    top += kRow;
  }
  const std::string height = fixed_text(scale * top, 1);
  std::string text =
      "<figure class=\"decisions\"><figcaption><b>Who decided when</b> <span>" + escaped(about) +
      "</span>" + key(rows, inks) + "</figcaption><div class=\"rows\"><svg class=\"names\" " +
      "width=\"64\" height=\"" + height + "\" aria-hidden=\"true\">" + labels + "</svg>" +
      "<svg class=\"bars\" role=\"img\" aria-label=\"Who decided when\" width=\"100%\" height=\"" +
      height + "\" viewBox=\"0 0 " + std::to_string(budget.columns) + " " + std::to_string(top) +
      "\" preserveAspectRatio=\"none\">";
  for (const auto& [who, bar] : bars) {
    text += "<g class=\"bar " + (who == "*" ? "several" : inks.behavior_class(who)) + "\"><title>" +
            escaped(who == "*" ? "several" : who) + "</title>";
    if (!bar.whole.empty()) {
      text += "<path class=\"whole\" d=\"" + bar.whole + "\"/>";
    }
    if (!bar.parts.empty()) {
      text += "<path d=\"" + bar.parts + "\"/>";
    }
    text += "</g>";
  }
  return text +
         "</svg><span></span><svg class=\"plot time\" width=\"100%\" height=\"18\" "
         "aria-hidden=\"true\">" +
         Span(0.0, end_s, 0.0).labels(picture::nice_ticks(0.0, end_s, 5), 13.0, " s") +
         "</svg></div></figure>\n";
}

}  // namespace elsie::report

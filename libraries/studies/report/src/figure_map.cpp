// A cell's world from above with the paths of its robots.
#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "elsie/picture/bodies.h"
#include "elsie/picture/page_map.h"
#include "elsie/plugin/host.h"
#include "elsie/world/error.h"

#include "figures.h"
#include "markup.h"
#include "numbers.h"
#include "words.h"

namespace elsie::report {

namespace {

using picture::MapPath;
using Kind = MapPath::Kind;

constexpr std::size_t kNamedRuns = 3;

struct Chosen {
  std::map<std::int64_t, Kind> runs;  // by id of the run
  std::size_t all = 0;
  std::map<Kind, std::size_t> counts;
};

// All runs of the sample, or as many as the budget allows: first outliers, then others evenly.
Chosen choose(const Findings& findings, std::size_t place, std::size_t most) {
  const CellFindings& cell = findings.cells[place];
  std::set<std::size_t> odd;
  for (const Outlier& outlier : cell.outliers) {
    odd.insert(outlier.run);
  }
  std::map<Kind, std::vector<std::int64_t>> kinds;
  Chosen chosen;
  for (const std::size_t at : cell.runs) {
    const Run& run = findings.results.runs[at];
    if (!run.ended()) {
      continue;
    }
    ++chosen.all;
    if (const auto& seed = findings.results.cells[place].seed; seed && run.seed != *seed) {
      continue;  // it had another world
    }
    kinds[run.broken() || findings.missed(run) ? Kind::missed
          : odd.contains(at)                   ? Kind::odd
                                               : Kind::plain]
        .push_back(run.id);
  }
  std::size_t left = most;
  for (const Kind kind : {Kind::odd, Kind::missed, Kind::plain}) {
    const auto& ids = kinds[kind];
    const std::size_t count =
        std::min(ids.size(), kind == Kind::plain ? left : std::min(left, (most + 1) / 2));
    for (std::size_t i = 0; i < count; ++i) {
      chosen.runs[ids[i * ids.size() / count]] = kind;
    }
    chosen.counts[kind] = count;
    left -= count;
  }
  return chosen;
}

std::vector<MapPath> paths_of(const Results& results, const std::vector<Trajectory>& ways,
                              const Chosen& chosen, bool several) {
  std::vector<MapPath> paths;
  std::set<std::int64_t> named;
  for (const Trajectory& way : ways) {
    const auto kind = chosen.runs.find(way.run);
    if (kind == chosen.runs.end()) continue;
    const auto run = std::lower_bound(results.runs.begin(), results.runs.end(), way.run,
                                      [](const Run& a, std::int64_t id) { return a.id < id; });
    MapPath& path = paths.emplace_back();
    path.kind = kind->second;
    for (const Pose& pose : way.poses) path.points.push_back({pose.x, pose.y});
    path.title = name_of(*run) + (several ? ", " + way.robot : "") + ": " + outcome_in_words(*run);
    if (path.kind != Kind::plain && named.size() < kNamedRuns && named.insert(way.run).second) {
      path.name = "run " + std::to_string(way.run);
    }
  }
  return paths;
}

std::string key(const Chosen& chosen, const std::string& ink,
                const std::optional<std::uint64_t>& seed) {
  std::string text = "<ul class=\"key\">";
  const auto item = [&](const std::string& kind, const std::string& words) {
    text += "<li class=\"" + ink +
            "\"><svg width=\"22\" height=\"10\" viewBox=\"0 0 220 100\" "
            "aria-hidden=\"true\"><path class=\"" +
            kind + "\" d=\"M0 50h220\"/></svg>" + words + "</li>";
  };
  if (chosen.counts.at(Kind::plain) > 0) {
    item("way solid", counted(chosen.counts.at(Kind::plain), "run"));
  }
  if (chosen.counts.at(Kind::odd) > 0) {
    item("way odd", counted(chosen.counts.at(Kind::odd), "outlier"));
  }
  if (chosen.counts.at(Kind::missed) > 0) {
    item("way missed", std::to_string(chosen.counts.at(Kind::missed)) + " without success");
  }
  text += "</ul>";
  if (chosen.runs.size() < chosen.all) {
    text += "<small>" + std::to_string(chosen.runs.size()) + " of " + std::to_string(chosen.all) +
            " runs are drawn.</small>";
  }
  if (seed) {
    text += "<small>Each seed has a layout of its own: this is the one of seed " +
            std::to_string(*seed) + ".</small>";
  }
  return text;
}

}  // namespace

std::string map_figure(const Findings& findings, std::size_t cell,
                       const std::vector<Trajectory>& ways, const Inks& inks,
                       const Budget& budget) {
  const CellInfo& info = findings.results.cells[cell];
  world::World world;
  try {
    world = picture::bodies_of(info.world_text, info.world_file, plugin::Host());
  } catch (const world::WorldError& error) {
    return "<p class=\"none\">The world of this cell cannot be drawn: " + escaped(error.what()) +
           "</p>";
  }
  const Chosen chosen = choose(findings, cell, budget.runs);
  const std::vector<MapPath> paths =
      paths_of(findings.results, ways, chosen, world.robots.size() > 1);
  return "<figure class=\"map " + inks.cell_class(cell) + "\">" +
         picture::page_map(world, paths, budget.points,
                           "The world from above with the paths of the robots") +
         "<figcaption>" + key(chosen, inks.cell_class(cell), info.seed) + "<small>" +
         brief(world.arena.length) + " m \xc3\x97 " + brief(world.arena.width) +
         " m</small></figcaption></figure>\n";
}

}  // namespace elsie::report

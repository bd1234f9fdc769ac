// A cell's world from above with the paths of its robots.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "elsie/picture/bodies.h"
#include "elsie/picture/polyline.h"
#include "elsie/picture/svg.h"
#include "elsie/plugin/host.h"
#include "elsie/world/colours.h"
#include "elsie/world/error.h"
#include "elsie/world/parts.h"

#include "figures.h"
#include "markup.h"
#include "numbers.h"
#include "words.h"

namespace elsie::report {

namespace {

// The longer side of the arena in units of the picture, about ten of which are a pixel on the page.
constexpr double kSide = 3600.0;
constexpr double kSmallestMark = 70.0;
constexpr std::size_t kNamedRobots = 10;
constexpr std::size_t kNamedOutliers = 3;
constexpr double kNameRoom = 180.0;  // room for the highest name, below the wall

struct View {
  double scale = 1.0;  // units per metre
  double width = kSide, height = kSide;
  static constexpr double margin = 60.0;

  explicit View(const world::Arena& arena)
      : scale(kSide / std::max({arena.length, arena.width, 1e-6})),
        width(scale * arena.length + 2.0 * margin),
        height(scale * arena.width + 2.0 * margin) {}

  Vector2 at(double x, double y) const {
    return {0.5 * width + scale * x, 0.5 * height - scale * y};
  }
};

std::string whole(double value) {
  return std::to_string(std::lround(std::clamp(value, -1e5, 1e5)));
}

using picture::hex_text;

std::string fill(const std::optional<Colour>& colour) {
  return colour ? " style=\"fill:" + hex_text(*colour) + "\"" : "";
}

std::string rectangle(const View& view, double x, double y, double heading_deg, double length,
                      double width, const std::string& rest) {
  const Vector2 at = view.at(x, y);
  const double w = std::max(length * view.scale, 1.0), h = std::max(width * view.scale, 1.0);
  std::string text = "<rect x=\"" + whole(at.x - 0.5 * w) + "\" y=\"" + whole(at.y - 0.5 * h) +
                     "\" width=\"" + whole(w) + "\" height=\"" + whole(h) + "\"" + rest;
  if (heading_deg != 0.0) {
    text += " transform=\"rotate(" + brief(-heading_deg) + " " + whole(at.x) + " " + whole(at.y) +
            ")\"";
  }
  return text + "/>";
}

std::string circle(const Vector2& at, double radius, const std::string& rest) {
  return "<circle cx=\"" + whole(at.x) + "\" cy=\"" + whole(at.y) + "\" r=\"" + whole(radius) +
         "\"" + rest + "/>";
}

std::string polygon(const View& view, const world::Box& prism, const std::string& rest) {
  std::string points;
  for (const Vector2& corner : world::fixture_of(prism).outline) {
    const Vector2 there = point_of({prism.x, prism.y, radians(prism.heading_deg)}, corner);
    const Vector2 at = view.at(there.x, there.y);
    points += (points.empty() ? "" : " ") + whole(at.x) + "," + whole(at.y);
  }
  return "<polygon points=\"" + points + "\"" + rest + "/>";
}

std::string ground(const View& view, const world::World& world) {
  std::string text = rectangle(view, 0, 0, 0, world.arena.length, world.arena.width,
                               world.arena.walls ? " class=\"floor walls\"" : " class=\"floor\"");
  for (const world::Charger& charger : world.chargers) {
    text += circle(
        view.at(charger.x, charger.y), std::max(kSmallestMark, charger.radius * view.scale),
        " class=\"charger\" style=\"stroke:" + hex_text(world::team_colour(world, charger.team)) +
            "\"");
  }
  for (const world::Goal& goal : world.goals) {
    if (const auto* reach = std::get_if<world::ReachGoal>(&goal); reach && reach->of.empty()) {
      text += circle(view.at(reach->x, reach->y), reach->radius * view.scale, " class=\"goal\"");
    } else if (const auto* push = std::get_if<world::PushGoal>(&goal)) {
      text += circle(view.at(push->x, push->y), push->radius * view.scale, " class=\"goal\"");
    }
  }
  return text;
}

std::string boxes(const View& view, const world::World& world) {
  std::string text;
  for (const world::Box& box : world.boxes) {
    if (box.kind == world::BoxKind::resource) {
      continue;
    }
    const std::string style =
        (box.kind == world::BoxKind::fixed ? " class=\"box\"" : " class=\"box loose\"") +
        fill(box.colour);
    text += box.shape == world::BoxShape::cylinder
                ? circle(view.at(box.x, box.y), box.radius * view.scale, style)
            : box.shape == world::BoxShape::prism
                ? polygon(view, box, style)
                : rectangle(view, box.x, box.y, box.heading_deg, box.length, box.width, style);
  }
  return text;
}

// Resources are drawn on top of the robots' paths.
std::string resources(const View& view, const world::World& world) {
  const double least = 1.6 * kSmallestMark / view.scale;
  std::string text;
  for (const world::Box& box : world.boxes) {
    if (box.kind != world::BoxKind::resource) {
      continue;
    }
    text += rectangle(view, box.x, box.y, box.heading_deg, std::max(box.length, least),
                      std::max(box.width, least),
                      " class=\"resource\"" + fill(world::resource_colour(world, box)));
  }
  return text;
}

std::string robots(const View& view, const world::World& world) {
  std::string text;
  for (const world::Robot& robot : world.robots) {
    const Vector2 at = view.at(robot.x, robot.y);
    text +=
        "<path class=\"start\" style=\"fill:" + hex_text(world::team_colour(world, robot.team)) +
        "\" transform=\"translate(" + whole(at.x) + " " + whole(at.y) + ")rotate(" +
        brief(-robot.heading_deg) + ")\" d=\"M95 0-60 62-30 0-60-62z\"><title>" +
        escaped(robot.id) + "</title></path>";
    if (world.robots.size() > 1 && world.robots.size() <= kNamedRobots) {
      text += "<text x=\"" + whole(at.x) + "\" y=\"" + whole(at.y - 110.0) + "\">" +
              escaped(output::shortened(robot.id, 14)) + "</text>";
    }
  }
  return text;
}

// Kinds of paths, drawn in this order.
enum Kind { kPlain, kMissed, kOdd, kKinds };
constexpr std::array<const char*, kKinds> kClasses = {"way", "way missed", "way odd"};

struct Chosen {
  std::map<std::int64_t, Kind> runs;  // by id of the run
  std::size_t all = 0;
  std::array<std::size_t, kKinds> counts{};
};

// All runs of the sample, or as many as the budget allows: first outliers, then others evenly.
Chosen choose(const Findings& findings, std::size_t place, std::size_t most) {
  const CellFindings& cell = findings.cells[place];
  std::set<std::size_t> odd;
  for (const Outlier& outlier : cell.outliers) {
    odd.insert(outlier.run);
  }
  std::array<std::vector<std::int64_t>, kKinds> kinds;
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
    kinds[run.broken() || findings.missed(run) ? kMissed
          : odd.contains(at)                   ? kOdd
                                               : kPlain]
        .push_back(run.id);
  }
  std::size_t left = most;
  for (const Kind kind : {kOdd, kMissed, kPlain}) {
    const auto& ids = kinds[kind];
    const std::size_t count =
        std::min(ids.size(), kind == kPlain ? left : std::min(left, (most + 1) / 2));
    for (std::size_t i = 0; i < count; ++i) {
      chosen.runs[ids[i * ids.size() / count]] = kind;
    }
    chosen.counts[kind] = count;
    left -= count;
  }
  return chosen;
}

struct Line {
  const Trajectory* way = nullptr;
  Kind kind = kPlain;
  std::vector<std::vector<Vector2>> pieces;
};

std::vector<Line> lines_of(const View& view, const std::vector<Trajectory>& ways,
                           const Chosen& chosen, std::size_t budget) {
  std::vector<Line> lines;
  for (const Trajectory& way : ways) {
    const auto run = chosen.runs.find(way.run);
    if (run == chosen.runs.end()) {
      continue;
    }
    std::vector<Vector2> points;
    for (const Pose& pose : way.poses) {
      points.push_back(view.at(pose.x, pose.y));
    }
    lines.push_back({&way, run->second, picture::pieces(points)});
    std::erase_if(lines.back().pieces, [](const auto& piece) { return piece.size() < 2; });
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const Line& a, const Line& b) { return a.kind < b.kind; });
  // Raises the tolerance until all lines together have few enough points.
  for (double tolerance = 4.0;; tolerance *= 1.6) {
    std::size_t points = 0;
    for (Line& line : lines) {
      for (auto& piece : line.pieces) {
        piece = picture::simplified(piece, tolerance);
        points += piece.size();
      }
    }
    if (points <= budget || tolerance > 200.0) {
      return lines;
    }
  }
}

std::string title_of(const Results& results, const Line& line, bool several) {
  const auto run = std::lower_bound(results.runs.begin(), results.runs.end(), line.way->run,
                                    [](const Run& a, std::int64_t id) { return a.id < id; });
  return name_of(*run) + (several ? ", " + line.way->robot : "") + ": " + outcome_in_words(*run);
}

std::string ways_of(const View& view, const Findings& findings, const std::vector<Line>& lines,
                    bool several) {
  std::string text;
  std::string ends, names;
  std::set<std::int64_t> named;
  std::vector<Vector2> taken;  // positions of names
  for (const Line& line : lines) {
    if (line.pieces.empty()) {
      continue;
    }
    std::string data;
    for (const auto& piece : line.pieces) {
      data += picture::path_data(piece);
    }
    text += "<path class=\"" + std::string(kClasses[line.kind]) + "\" d=\"" + data + "\"><title>" +
            escaped(title_of(findings.results, line, several)) + "</title></path>";
    const Vector2 end = line.pieces.back().back();
    if (line.kind == kMissed) {
      ends += "<path class=\"stop\" d=\"M" + whole(end.x - 45) + " " + whole(end.y - 45) +
              "l90 90m0-90-90 90\"/>";
    } else {
      ends += circle(end, line.kind == kOdd ? 42 : 30,
                     line.kind == kOdd ? " class=\"end odd\"" : " class=\"end\"");
    }
    const bool free = std::none_of(taken.begin(), taken.end(), [&](const Vector2& other) {
      return std::abs(other.x - end.x) < 600.0 && std::abs(other.y - end.y) < 120.0;
    });
    if (line.kind == kPlain || !free || named.size() >= kNamedOutliers ||
        !named.insert(line.way->run).second) {
      continue;
    }
    taken.push_back(end);
    const bool right = end.x > 0.7 * kSide;
    names += "<text class=\"" + std::string(right ? "run to-left" : "run") + "\" x=\"" +
             whole(end.x + (right ? -80.0 : 80.0)) + "\" y=\"" +
             whole(std::clamp(end.y + 35.0, kNameRoom, std::max(kNameRoom, view.height - 100.0))) +
             "\">run " + std::to_string(line.way->run) + "</text>";
  }
  return text + ends + names;
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
  if (chosen.counts[kPlain] > 0) {
    item("way solid", counted(chosen.counts[kPlain], "run"));
  }
  if (chosen.counts[kOdd] > 0) {
    item("way odd", counted(chosen.counts[kOdd], "outlier"));
  }
  if (chosen.counts[kMissed] > 0) {
    item("way missed", std::to_string(chosen.counts[kMissed]) + " without success");
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
  const View view(world.arena);
  const Chosen chosen = choose(findings, cell, budget.runs);
  const std::vector<Line> lines = lines_of(view, ways, chosen, budget.points);
  // The more lines, the more transparent each is.
  const double opacity =
      std::clamp(3.0 / std::sqrt(std::max(1.0, static_cast<double>(lines.size()))), 0.3, 1.0);
  return "<figure class=\"map " + inks.cell_class(cell) + "\"><svg viewBox=\"0 0 " +
         whole(view.width) + " " + whole(view.height) +
         "\" role=\"img\" aria-label=\"The world from above with the paths of the robots\" "
         "style=\"--through:" +
         brief(opacity, 2) + "\">" + ground(view, world) + boxes(view, world) +
         ways_of(view, findings, lines, world.robots.size() > 1) + resources(view, world) +
         robots(view, world) + "</svg><figcaption>" +
         key(chosen, inks.cell_class(cell), info.seed) + "<small>" + brief(world.arena.length) +
         " m \xc3\x97 " + brief(world.arena.width) + " m</small></figcaption></figure>\n";
}

}  // namespace elsie::report

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "elsie/api/geometry.h"
#include "elsie/base/grid.h"
#include "elsie/base/number_text.h"
#include "elsie/shapes/outline.h"
#include "elsie/world/floor.h"
#include "elsie/world/footprint.h"
#include "elsie/world/parts.h"

#include "reading.h"
#include "refusals.h"

namespace elsie::world {
namespace {
using base::number_text;

// The area of a body, and the body's name in messages.
struct Block {
  Footprint footprint;
  std::string in_words;
  Location where;
};

// The blocks of a robot and, if wanted, of its segments in line behind it.
std::vector<Block> blocks_of(const Robot& robot, bool with_segments) {
  const std::string in_words = "the robot '" + robot.id + "'";
  const BodyPlan driven = driven_plan(robot);
  const auto footprints = footprints_of(with_segments ? plan_of(robot) : driven,
                                        {robot.x, robot.y, radians(robot.heading_deg)}, robot.z);
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    if (i < driven.vehicles()) {
      blocks.push_back({footprints[i], in_words, robot.location});
      continue;
    }
    const Segment& segment = robot.segments[i - driven.vehicles()];
    blocks.push_back(
        {footprints[i], "the segment '" + segment.id + "' of " + in_words, segment.location});
  }
  return blocks;
}

class PlaceCheck {
 public:
  PlaceCheck(const Arena& arena, Problems& problems)
      : arena_(arena), problems_(problems), grid_(arena.length, arena.width) {}

  void report(std::optional<std::string> problem, const Location& where) {
    if (problem) problems_.add(where, std::move(*problem));
  }
  void check_point(const std::string& what, double x, double y, const Location& where) {
    report(outside(arena_, what, x, y), where);
  }
  // Checks that a block is inside the arena and not in a wall.
  void check_free_of_walls(const Block& block) {
    report(outside(arena_, block.in_words, block.footprint), block.where);
  }

  /// Checks that the parts of a body overlap nothing that was added before, in that order; then
  /// adds the body. `may_overlap` says whether it may overlap an earlier one.
  template <class MayOverlap>
  void check_apart(std::span<const Block> body, MayOverlap may_overlap) {
    for (const Block& part : body) {
      for (const base::Grid::Id other : near(part.footprint)) {
        const Block& earlier = there_[other];
        if (!may_overlap(other) && overlap(part.footprint, earlier.footprint)) {
          problems_.add(part.where, part.in_words + " overlaps " + earlier.in_words +
                                        on_line(earlier.where, part.where));
        }
      }
    }
    for (const Block& part : body) {
      grid_.insert(static_cast<base::Grid::Id>(there_.size()), cells(part.footprint));
      there_.push_back(part);
    }
  }

  void check_path(const Obstacle& obstacle) {
    Vector2 last{obstacle.x, obstacle.y};
    for (const Vector2& point : obstacle.waypoints) {
      check_point("a waypoint of " + obstacle.in_words(), point.x, point.y, obstacle.location);
      if (point == last) {
        problems_.add(obstacle.location, "a waypoint of " + obstacle.in_words() + " at (" +
                                             number_text(point.x) + ", " + number_text(point.y) +
                                             ") is where the " + obstacle.shape_name() +
                                             " comes from; take it out");
      }
      last = point;
    }
  }

 private:
  base::Grid::Block cells(const Footprint& area) const {
    return grid_.block(area.x - area.reach(-1.0, 0.0), area.y - area.reach(0.0, -1.0),
                       area.x + area.reach(1.0, 0.0), area.y + area.reach(0.0, 1.0));
  }

  /// The bodies that share a grid cell with the area, each once.
  std::vector<base::Grid::Id> near(const Footprint& area) const {
    std::vector<base::Grid::Id> found;
    const base::Grid::Block block = cells(area);
    for (int y = block.y0; y <= block.y1; ++y) {
      for (int x = block.x0; x <= block.x1; ++x) {
        const auto cell = grid_.cell(x, y);
        found.insert(found.end(), cell.begin(), cell.end());
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  const Arena& arena_;
  Problems& problems_;
  base::Grid grid_;
  std::vector<Block> there_;
};

void check_patch(const Patch& patch, PlaceCheck& check, Problems& problems) {
  const std::string in_words = "the patch '" + patch.id + "'";
  const bool is_line = patch.shape == PatchShape::line;
  const auto problem = patch.shape == PatchShape::polygon
                           ? problem_of_outline(patch.points, "patches")
                       : is_line && patch.points.size() < 2
                           ? std::optional<std::string>("has 1 point; expected at least 2")
                           : std::nullopt;
  if (problem) problems.add(patch.location, in_words + " " + *problem);
  if (!is_line) {
    check.check_point(in_words, patch.x, patch.y, patch.location);
    return;
  }
  const std::vector<Vector2> points = points_of_line(patch);
  for (std::size_t i = 0; i < points.size(); ++i) {
    check.check_point("a point of " + in_words, points[i].x, points[i].y, patch.location);
    if (i > 0 &&
        std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y) < kLeastLength) {
      problems.add(patch.location, in_words + " has two points in a row at (" +
                                       number_text(patch.points[i].x) + ", " +
                                       number_text(patch.points[i].y) + "); take one out");
    }
  }
}

/// A lamp must not be inside of an obstacle; of a running world, only those that stay are known.
void check_lamp(const Lamp& lamp, const Reading& reading, bool is_running, PlaceCheck& check,
                Problems& problems) {
  const std::string in_words = "the lamp '" + lamp.id + "'";
  check.check_point(in_words, lamp.x, lamp.y, lamp.location);
  const Footprint area{.x = lamp.x, .y = lamp.y, .bottom = lamp.z, .top = lamp.z, .round = true};
  for (const Obstacle& obstacle : reading.world.obstacles) {
    if (lamp.z >= obstacle.z + obstacle.height || !reading.sound(obstacle.location) ||
        (is_running && obstacle.kind != ObstacleKind::fixed) || problem_of(obstacle)) {
      continue;
    }
    if (overlap(area, footprint_of(obstacle))) {
      problems.add(lamp.location, in_words + " is inside " + obstacle.in_words() +
                                      on_line(obstacle.location, lamp.location) +
                                      ", which hides it; expected a free place");
    }
  }
}

/// What is released in a nest must be in one nest only.
void check_nests(const Reading& reading, PlaceCheck& check, Problems& problems) {
  const std::vector<Nest>& nests = reading.world.nests;
  for (std::size_t i = 0; i < nests.size(); ++i) {
    const Nest& nest = nests[i];
    if (!reading.sound(nest.location)) continue;
    check.check_point("the nest '" + nest.id + "'", nest.x, nest.y, nest.location);
    for (std::size_t k = 0; k < i; ++k) {
      const Nest& other = nests[k];
      const bool share = nest.team.empty() || other.team.empty() || nest.team == other.team;
      if (!share || !reading.sound(other.location) ||
          std::hypot(nest.x - other.x, nest.y - other.y) >= nest.radius + other.radius) {
        continue;
      }
      problems.add(nest.location, "the nest '" + nest.id + "' overlaps the nest '" + other.id +
                                      "'" + on_line(other.location, nest.location) +
                                      ", and what is released there would be in both; expected "
                                      "nests apart, or of different teams");
    }
  }
}
}  // namespace

void check_places(const Reading& reading, bool is_running, Problems& problems) {
  const World& world = reading.world;
  PlaceCheck check(world.arena, problems);
  std::vector<ObstacleKind> kinds;
  const auto is_free = [](ObstacleKind kind) {
    return kind == ObstacleKind::dynamic || kind == ObstacleKind::resource;
  };
  check_nests(reading, check, problems);
  for (const Obstacle& obstacle : world.obstacles) {
    if (!reading.sound(obstacle.location)) continue;
    if (const auto problem = problem_of(obstacle)) {
      problems.add(obstacle.location, obstacle.in_words() + " " + *problem);
      continue;
    }
    const Block block{footprint_of(obstacle), obstacle.in_words(), obstacle.location};
    check.check_path(obstacle);
    if (obstacle.kind == ObstacleKind::fixed || obstacle.kind == ObstacleKind::moving) {
      check.check_point(block.in_words, obstacle.x, obstacle.y, obstacle.location);
    } else if (!is_running) {
      check.check_free_of_walls(block);
    }
    if (is_running) continue;
    check.check_apart({&block, 1}, [&](std::size_t other) {
      return !is_free(kinds[other]) && !is_free(obstacle.kind);
    });
    kinds.push_back(obstacle.kind);
  }
  for (const Charger& charger : world.chargers) {
    if (reading.sound(charger.location)) {
      check.check_point("the charger '" + charger.id + "'", charger.x, charger.y, charger.location);
    }
  }
  for (const Patch& patch : world.patches) {
    if (reading.sound(patch.location)) check_patch(patch, check, problems);
  }
  for (const Lamp& lamp : world.lamps) {
    if (reading.sound(lamp.location)) check_lamp(lamp, reading, is_running, check, problems);
  }
  if (is_running) return;
  for (const Robot& robot : world.robots) {
    if (!reading.sound(robot.location)) continue;
    const std::vector<Block> parts = blocks_of(robot, reading.sound_with_segments(robot));
    for (const Block& part : parts) {
      check.check_free_of_walls(part);
    }
    check.check_apart(parts, [](std::size_t) { return false; });
  }
}

}  // namespace elsie::world

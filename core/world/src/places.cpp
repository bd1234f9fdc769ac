#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "elsie/api/geometry.h"
#include "elsie/base/number_text.h"
#include "elsie/world/footprint.h"
#include "elsie/world/parts.h"

#include "checks.h"

namespace elsie::world {

namespace {

using base::number_text;

// The area of a body, and the body's name in messages.
struct Block {
  Footprint footprint;
  std::string in_words;
  Location where;
};

Block block_of(const Box& box) {
  return {footprint_of(box), "the box '" + box.id + "'", box.location};
}

// A robot, and its segments in line behind it if wanted.
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
  PlaceCheck(const Arena& arena, Problems& problems) : arena_(arena), problems_(problems) {}

  void check_point(const std::string& what, double x, double y, const Location& where) {
    if (auto problem = outside(arena_, what, x, y)) {
      problems_.add(where, std::move(*problem));
    }
  }

  // Not outside, and not in a wall.
  void check_free_of_walls(const Block& block) {
    if (auto problem = outside(arena_, block.in_words, block.footprint)) {
      problems_.add(block.where, std::move(*problem));
    }
  }

  void check_apart(const Block& later, const Block& earlier) {
    if (overlap(later.footprint, earlier.footprint)) {
      problems_.add(later.where, later.in_words + " overlaps " + earlier.in_words + " (line " +
                                     std::to_string(earlier.where.line) + ")");
    }
  }

  void check_path(const Box& box) {
    Vector2 last{box.x, box.y};
    for (const Vector2& point : box.waypoints) {
      check_point("a waypoint of the box '" + box.id + "'", point.x, point.y, box.location);
      if (point == last) {
        problems_.add(box.location, "a waypoint of the box '" + box.id + "' at (" +
                                        number_text(point.x) + ", " + number_text(point.y) +
                                        ") is where the box comes from; take it out");
      }
      last = point;
    }
  }

 private:
  const Arena& arena_;
  Problems& problems_;
};

}  // namespace

void check_places(const Reading& reading, Problems& problems) {
  const World& world = reading.world;
  PlaceCheck check(world.arena, problems);
  std::vector<Block> boxes, robots;
  std::vector<BoxKind> kinds;
  for (const Box& box : world.boxes) {
    if (!reading.sound(box.location)) {
      continue;
    }
    const Block block = block_of(box);
    check.check_path(box);
    if (box.kind == BoxKind::fixed || box.kind == BoxKind::moving) {
      check.check_point(block.in_words, box.x, box.y, box.location);
    } else {
      check.check_free_of_walls(block);
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const auto free = [](BoxKind kind) {
        return kind == BoxKind::dynamic || kind == BoxKind::resource;
      };
      if (free(kinds[i]) || free(box.kind)) {
        check.check_apart(block, boxes[i]);
      }
    }
    boxes.push_back(block);
    kinds.push_back(box.kind);
  }
  for (const Charger& charger : world.chargers) {
    if (reading.sound(charger.location)) {
      check.check_point("the charger '" + charger.id + "'", charger.x, charger.y, charger.location);
    }
  }
  for (const Robot& robot : world.robots) {
    if (!reading.sound(robot.location)) {
      continue;
    }
    const std::vector<Block> parts = blocks_of(robot, reading.sound_with_segments(robot));
    for (const Block& part : parts) {
      check.check_free_of_walls(part);
      for (const Block& box : boxes) {
        check.check_apart(part, box);
      }
      for (const Block& other : robots) {
        check.check_apart(part, other);
      }
    }
    robots.insert(robots.end(), parts.begin(), parts.end());
  }
}

}  // namespace elsie::world

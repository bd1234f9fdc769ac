#include <algorithm>
#include <cmath>
#include <string>

#include "elsie/api/geometry.h"
#include "elsie/world/train.h"

#include "checks.h"
#include "values.h"

namespace elsie::world {

namespace {

constexpr double kTouching = 1e-6;  // m: this much overlap is none

std::string number(double value) { return format_value(ParameterValue(value)); }

// A length in a message: to the tenth of a millimetre.
std::string rounded(double metres) { return number(std::round(metres * 1e4) / 1e4); }

// What something covers: a turned rectangle on the floor, from a bottom to a top.
struct Block {
  double x, y, heading, half_length, half_width, bottom, top;
  std::string in_words;
  Location where;

  // How far it reaches from its middle along a direction.
  double reach(double ux, double uy) const {
    const double c = std::cos(heading), s = std::sin(heading);
    return half_length * std::abs(ux * c + uy * s) + half_width * std::abs(-ux * s + uy * c);
  }
};

Block block_of(const Box& box) {
  return {box.x,           box.y, radians(box.heading_deg), 0.5 * box.length,
          0.5 * box.width, box.z, box.z + box.height,       "the box '" + box.id + "'",
          box.location};
}

Block block_of(const Robot& robot) {
  const RobotBody& body = robot.body;
  return {robot.x,
          robot.y,
          radians(robot.heading_deg),
          std::max(0.5 * body.length, body.wheel_radius),
          std::max(0.5 * body.width, body.half_axle() + 0.5 * body.wheel_width),
          robot.z,
          robot.z + std::max(body.top(), 2.0 * body.wheel_radius),
          "the robot '" + robot.id + "'",
          robot.location};
}

// A robot, and what it pulls in line behind it.
std::vector<Block> blocks_of(const Robot& robot) {
  std::vector<Block> blocks{block_of(robot)};
  const double c = std::cos(blocks[0].heading), s = std::sin(blocks[0].heading);
  const std::vector<Coupling> chain = couplings(robot.body, robot.segments);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Segment& segment = robot.segments[i];
    blocks.push_back({robot.x - chain[i].place * c, robot.y - chain[i].place * s, blocks[0].heading,
                      std::max(0.5 * segment.length, segment.wheel_radius), 0.5 * segment.width,
                      robot.z, robot.z + std::max(segment.top(), 2.0 * segment.wheel_radius),
                      "the segment '" + segment.id + "' of the robot '" + robot.id + "'",
                      segment.location});
  }
  return blocks;
}

// By the separating axis theorem, on the four axes of the two rectangles.
bool overlap(const Block& a, const Block& b) {
  if (a.bottom >= b.top - kTouching || b.bottom >= a.top - kTouching) {
    return false;
  }
  const double dx = b.x - a.x, dy = b.y - a.y;
  if (std::hypot(dx, dy) >=
      std::hypot(a.half_length, a.half_width) + std::hypot(b.half_length, b.half_width)) {
    return false;
  }
  for (const double heading : {a.heading, b.heading}) {
    const double c = std::cos(heading), s = std::sin(heading);
    for (const auto& [ux, uy] : {std::pair(c, s), std::pair(-s, c)}) {
      if (std::abs(dx * ux + dy * uy) >= a.reach(ux, uy) + b.reach(ux, uy) - kTouching) {
        return false;
      }
    }
  }
  return true;
}

class PlaceCheck {
 public:
  PlaceCheck(const Arena& arena, Problems& problems) : arena_(arena), problems_(problems) {}

  bool inside(double x, double y) const {
    return std::abs(x) <= 0.5 * arena_.length && std::abs(y) <= 0.5 * arena_.width;
  }

  void check_point(const std::string& what, double x, double y, const Location& where) {
    if (!inside(x, y)) {
      problems_.add(where, what + " at (" + number(x) + ", " + number(y) +
                               ") is outside of the arena, which reaches from " +
                               number(-0.5 * arena_.length) + " to " + number(0.5 * arena_.length) +
                               " in x and from " + number(-0.5 * arena_.width) + " to " +
                               number(0.5 * arena_.width) + " in y");
    }
  }

  // Not outside, and not in a wall.
  void check_free_of_walls(const Block& block) {
    check_point(block.in_words, block.x, block.y, block.where);
    if (!arena_.walls || !inside(block.x, block.y) || block.bottom >= arena_.wall_height) {
      return;
    }
    const struct {
      const char* name;
      double overhang;
    } sides[] = {{"east", block.x + block.reach(1, 0) - 0.5 * arena_.length},
                 {"west", -block.x + block.reach(1, 0) - 0.5 * arena_.length},
                 {"north", block.y + block.reach(0, 1) - 0.5 * arena_.width},
                 {"south", -block.y + block.reach(0, 1) - 0.5 * arena_.width}};
    for (const auto& side : sides) {
      if (side.overhang > kTouching) {
        problems_.add(block.where, block.in_words + " reaches " + rounded(side.overhang) +
                                       " m into the " + side.name + " wall");
        return;
      }
    }
  }

  void check_apart(const Block& later, const Block& earlier) {
    if (overlap(later, earlier)) {
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
                                        number(point.x) + ", " + number(point.y) +
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
    const std::vector<Block> parts =
        reading.sound_with_segments(robot) ? blocks_of(robot) : std::vector<Block>{block_of(robot)};
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

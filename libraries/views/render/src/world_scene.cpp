#include "elsie/render/world_scene.h"

#include "elsie/world/colours.h"
#include "elsie/world/train.h"

namespace elsie::render {
namespace {

constexpr Colour grey(std::uint8_t brightness) { return {brightness, brightness, brightness}; }

// Without a hue, and darker than white in the shade (kDarkestShade).
constexpr Colour kFloor = grey(80);
constexpr Colour kSky = grey(140);
constexpr Colour kWall = grey(130);
constexpr Colour kFixedBox = grey(115);
constexpr Colour kDynamicBox = grey(85);
constexpr Colour kMovingBox = grey(70);
constexpr Colour kChassis = grey(120);
constexpr Colour kTyre = grey(25);

Colour colour_of(const world::World& world, const world::Box& box) {
  switch (box.kind) {
    case world::BoxKind::fixed:
      return box.colour.value_or(kFixedBox);
    case world::BoxKind::dynamic:
      return box.colour.value_or(kDynamicBox);
    case world::BoxKind::moving:
      return box.colour.value_or(kMovingBox);
    case world::BoxKind::resource:
      break;
  }
  return world::resource_colour(world, box);
}

}  // namespace

WorldScene::WorldScene(const world::World& world, const Look& look) {
  scene_.floor = kFloor;
  scene_.sky = kSky;
  if (world.arena.walls) {
    add_walls(world.arena);
  }
  for (const world::Charger& charger : world.chargers) {
    if (charger.seen_by_range_sensors) {
      constexpr double edge = world::Charger::kBoxEdge;
      scene_.boxes.push_back(
          {{.origin = {charger.x, charger.y, 0.0}}, {edge, edge, edge}, world::kChargerColour});
    } else {
      scene_.marks.push_back({{charger.x, charger.y}, charger.radius, world::kChargerColour});
    }
  }
  first_box_ = scene_.boxes.size();
  for (const world::Box& box : world.boxes) {
    scene_.boxes.push_back({Frame::turned({box.x, box.y, box.z}, radians(box.heading_deg), 0.0),
                            {box.length, box.width, box.height},
                            colour_of(world, box)});
  }
  for (const world::Robot& robot : world.robots) {
    add_robot(robot, look.team_coloured_robots ? world::team_colour(world, robot.team) : kChassis);
  }
}

void WorldScene::add_walls(const world::Arena& arena) {
  // Outside of the arena; those along x are long enough to close the corners.
  const double t = arena.wall_thickness, h = arena.wall_height;
  const double x = 0.5 * (arena.length + t), y = 0.5 * (arena.width + t);
  const auto add = [&](double at_x, double at_y, double length, double width) {
    scene_.boxes.push_back({{.origin = {at_x, at_y, 0.0}}, {length, width, h}, kWall});
  };
  add(x, 0.0, t, arena.width);
  add(0.0, y, arena.length + 2.0 * t, t);
  add(-x, 0.0, t, arena.width);
  add(0.0, -y, arena.length + 2.0 * t, t);
}

void WorldScene::add_robot(const world::Robot& robot, const Colour& colour) {
  const std::size_t index = robots_.size();
  const Frame frame = Frame::turned({robot.x, robot.y, robot.z}, radians(robot.heading_deg), 0.0);
  robots_.push_back(add_body(robot.body, colour, index));
  place_robot(index, frame);
  auto& segments = segments_.emplace_back();
  const auto couplings = world::couplings(robot.body, robot.segments);
  for (std::size_t i = 0; i < couplings.size(); ++i) {
    segments.push_back(add_body(robot.segments[i], colour, index));
    place_segment(index, i, frame.frame({.origin = {-couplings[i].place, 0.0, 0.0}}));
  }
}

template <class Part>
WorldScene::Body WorldScene::add_body(const Part& part, const Colour& colour, std::size_t carrier) {
  const Body body{scene_.boxes.size(), scene_.wheels.size(), part.clearance, part.half_axle(),
                  part.wheel_radius};
  scene_.boxes.push_back({{}, {part.length, part.width, part.height}, colour, carrier});
  for (int i = 0; i < 2; ++i) {
    scene_.wheels.push_back({{}, part.wheel_radius, part.wheel_width, kTyre, carrier});
  }
  return body;
}

void WorldScene::place_robot(std::size_t robot, const Frame& frame) {
  place(robots_.at(robot), frame);
}

void WorldScene::place_segment(std::size_t robot, std::size_t segment, const Frame& frame) {
  place(segments_.at(robot).at(segment), frame);
}

void WorldScene::place(const Body& body, const Frame& frame) {
  const auto moved_to = [&](const Vector3& place) {
    return Frame{frame.point(place), frame.forward, frame.left, frame.up};
  };
  scene_.boxes[body.chassis].frame = moved_to({0.0, 0.0, body.clearance});
  scene_.wheels[body.first_wheel].frame = moved_to({0.0, body.half_axle, body.wheel_radius});
  scene_.wheels[body.first_wheel + 1].frame = moved_to({0.0, -body.half_axle, body.wheel_radius});
}

void WorldScene::place_box(std::size_t box, const std::optional<Frame>& frame) {
  Box& placed = scene_.boxes.at(first_box_ + box);
  placed.visible = frame.has_value();
  if (frame) {
    placed.frame = *frame;
  }
}

}  // namespace elsie::render

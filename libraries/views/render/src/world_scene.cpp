#include "elsie/render/world_scene.h"

#include "elsie/world/colours.h"

namespace elsie::render {
namespace {

constexpr Colour grey(std::uint8_t brightness) { return {brightness, brightness, brightness}; }

// Without a hue, and darker than white in the shade (kDarkestShade).
constexpr Colour kFloor = grey(80);
constexpr Colour kSky = grey(140);
constexpr Colour kWall = grey(130);
constexpr world::BoxColours kBoxes{grey(115), grey(85), grey(70)};
constexpr Colour kChassis = grey(120);
constexpr Colour kTyre = grey(25);

/// A box in the form of render::Box: the origin in the middle of its bottom.
Box box_of(const Frame& middle, const Vector3& size, const Colour& colour,
           std::size_t carrier = kNobody) {
  return {{middle.point({0.0, 0.0, -0.5 * size.z}), middle.forward, middle.left, middle.up},
          size,
          colour,
          carrier};
}

/// The frame of an upright cylinder as one of the scene, which lies along its left axis.
Frame lying(const Frame& upright) {
  return {upright.origin, upright.forward, upright.up, -1.0 * upright.left};
}

}  // namespace

WorldScene::WorldScene(const world::World& world, const Look& look) {
  scene_.floor = kFloor;
  scene_.sky = kSky;
  for (const world::Fixture& wall : world::walls_of(world.arena)) {
    scene_.boxes.push_back(box_of(wall.frame, wall.shape.size, kWall));
  }
  for (const world::Charger& charger : world.chargers) {
    const world::Fixture fixture = world::fixture_of(charger);
    if (charger.seen_by_range_sensors) {
      scene_.boxes.push_back(box_of(fixture.frame, fixture.shape.size, world::kChargerColour));
    } else {
      scene_.marks.push_back(
          {{charger.x, charger.y}, fixture.shape.radius(), world::kChargerColour});
    }
  }
  for (const world::Box& box : world.boxes) {
    add_box(world::fixture_of(box), world::box_colour(world, box, kBoxes));
  }
  for (const world::Robot& robot : world.robots) {
    add_robot(robot, look.team_coloured_robots ? world::team_colour(world, robot.team) : kChassis);
  }
}

void WorldScene::add_box(const world::Fixture& fixture, const Colour& colour) {
  const Shape& shape = fixture.shape;
  const Frame bottom{.origin = {0.0, 0.0, -0.5 * shape.size.z}};
  if (!fixture.outline.empty()) {
    boxes_.push_back({Placed::List::prisms, scene_.prisms.size(), {}});
    scene_.prisms.push_back({fixture.frame.frame(bottom), fixture.outline, shape.size.z, colour});
  } else if (shape.kind == Shape::Kind::cylinder) {
    const Frame middle = lying({.origin = {0.0, 0.0, 0.5 * shape.size.z}});
    boxes_.push_back({Placed::List::cylinders, scene_.cylinders.size(), middle});
    scene_.cylinders.push_back(
        {lying(fixture.frame), shape.radius(), shape.length(), colour, kNobody});
  } else {
    boxes_.push_back({Placed::List::boxes, scene_.boxes.size(), {}});
    scene_.boxes.push_back(box_of(fixture.frame, shape.size, colour));
  }
}

void WorldScene::add_robot(const world::Robot& robot, const Colour& colour) {
  const std::size_t index = robots_.size();
  const BodyPlan plan = world::plan_of(robot);
  std::vector<Vehicle>& vehicles = robots_.emplace_back(plan.vehicles());
  for (const Part& part : plan.parts) {
    if (part.role == PartRole::caster) continue;  // out of sight below the chassis
    add_part(vehicles[part.vehicle], part, part.role == PartRole::wheel ? kTyre : colour, index);
  }
  const Frame start = Frame::turned({robot.x, robot.y, robot.z}, radians(robot.heading_deg), 0.0);
  const std::vector<Frame> frames = world::in_line(plan);
  for (std::size_t i = 0; i < frames.size(); ++i) place(vehicles[i], start.frame(frames[i]));
}

void WorldScene::add_part(Vehicle& vehicle, const Part& part, const Colour& colour,
                          std::size_t carrier) {
  const Shape& shape = part.shape;
  const double radius = shape.radius();
  const bool is_capsule = shape.kind == Shape::Kind::capsule;
  const Frame along = along_axis(part.frame, shape.axis);
  const auto add_ball = [&](double away) {
    vehicle.push_back(
        {Placed::List::balls, scene_.balls.size(), {.origin = along.point({0.0, 0.0, away})}});
    scene_.balls.push_back({{}, radius, colour, carrier});
  };
  switch (shape.kind) {
    case Shape::Kind::box:
      vehicle.push_back({Placed::List::boxes, scene_.boxes.size(), part.frame});
      scene_.boxes.push_back(box_of({}, shape.size, colour, carrier));
      break;
    case Shape::Kind::sphere:
      add_ball(0.0);
      break;
    default:
      const double length = shape.length() - (is_capsule ? 2.0 * radius : 0.0);
      vehicle.push_back({Placed::List::cylinders, scene_.cylinders.size(), lying(along)});
      scene_.cylinders.push_back({{}, radius, length, colour, carrier});
      if (is_capsule) {
        add_ball(0.5 * length);
        add_ball(-0.5 * length);
      }
  }
}

void WorldScene::place_robot(std::size_t robot, const Frame& frame) {
  place(robots_.at(robot).front(), frame);
}

void WorldScene::place_segment(std::size_t robot, std::size_t segment, const Frame& frame) {
  place(robots_.at(robot).at(segment + 1), frame);
}

void WorldScene::place(const Vehicle& vehicle, const Frame& frame) {
  for (const Placed& part : vehicle) {
    const Frame middle = frame.frame(part.frame);
    switch (part.list) {
      case Placed::List::boxes: {
        Box& box = scene_.boxes[part.index];
        box = box_of(middle, box.size, box.colour, box.carrier);
        break;
      }
      case Placed::List::prisms:  // robots have none
        break;
      case Placed::List::cylinders:
        scene_.cylinders[part.index].frame = middle;
        break;
      case Placed::List::balls:
        scene_.balls[part.index].middle = middle.origin;
        break;
    }
  }
}

void WorldScene::place_box(std::size_t box, const std::optional<Frame>& frame) {
  const Placed& placed = boxes_.at(box);
  const auto move = [&](auto& solid) {
    solid.visible = frame.has_value();
    if (frame) solid.frame = frame->frame(placed.frame);
  };
  switch (placed.list) {
    case Placed::List::prisms:
      return move(scene_.prisms[placed.index]);
    case Placed::List::cylinders:
      return move(scene_.cylinders[placed.index]);
    default:
      return move(scene_.boxes[placed.index]);
  }
}

}  // namespace elsie::render

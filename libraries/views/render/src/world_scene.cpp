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

/// A box, as render::Box has it: the origin in the middle of its bottom.
Box box_of(const Frame& middle, const Vector3& size, const Colour& colour,
           std::size_t carrier = kNobody) {
  return {{middle.point({0.0, 0.0, -0.5 * size.z}), middle.forward, middle.left, middle.up},
          size,
          colour,
          carrier};
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
  first_box_ = scene_.boxes.size();
  for (const world::Box& box : world.boxes) {
    const world::Fixture fixture = world::fixture_of(box);
    scene_.boxes.push_back(
        box_of(fixture.frame, fixture.shape.size, world::box_colour(world, box, kBoxes)));
  }
  for (const world::Robot& robot : world.robots) {
    add_robot(robot, look.team_coloured_robots ? world::team_colour(world, robot.team) : kChassis);
  }
}

void WorldScene::add_robot(const world::Robot& robot, const Colour& colour) {
  const std::size_t index = robots_.size();
  const BodyPlan plan = world::plan_of(robot);
  std::vector<Vehicle>& vehicles = robots_.emplace_back(plan.vehicles());
  for (const Part& part : plan.parts) {
    if (part.role == PartRole::caster) continue;  // out of sight below the chassis
    Vehicle& vehicle = vehicles[part.vehicle];
    if (part.shape.kind == Shape::Kind::box) {
      vehicle.push_back({true, scene_.boxes.size(), part.frame});
      scene_.boxes.push_back(box_of({}, part.shape.size, colour, index));
    } else {
      vehicle.push_back({false, scene_.wheels.size(), part.frame});
      scene_.wheels.push_back({{},
                               part.shape.radius(),
                               part.shape.length(),
                               part.role == PartRole::wheel ? kTyre : colour,
                               index});
    }
  }
  const Frame start = Frame::turned({robot.x, robot.y, robot.z}, radians(robot.heading_deg), 0.0);
  const std::vector<Frame> frames = world::in_line(plan);
  for (std::size_t i = 0; i < frames.size(); ++i) place(vehicles[i], start.frame(frames[i]));
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
    if (part.is_box) {
      Box& box = scene_.boxes[part.index];
      box = box_of(middle, box.size, box.colour, box.carrier);
    } else {
      scene_.wheels[part.index].frame = middle;
    }
  }
}

void WorldScene::place_box(std::size_t box, const std::optional<Frame>& frame) {
  Box& placed = scene_.boxes.at(first_box_ + box);
  placed.visible = frame.has_value();
  if (frame) {
    placed.frame = *frame;
  }
}

}  // namespace elsie::render

#include "elsie/render/world_scene.h"

#include "elsie/world/floor.h"

namespace elsie::render {
namespace {

constexpr Colour grey(std::uint8_t brightness) { return {brightness, brightness, brightness}; }

// Without a hue, and darker than white in the shade (kDarkestShade).
constexpr Colour kFloor = grey(80);
constexpr Colour kSky = grey(140);
constexpr Colour kChassis = grey(120);
constexpr int kRoundPatch = 32;  // corners of a round patch

}  // namespace

WorldScene::WorldScene(const world::World& world, Viewer viewer) {
  const world::Colours& colours = viewer == Viewer::person ? world::kShown : world::kSeen;
  scene_.floor = world.floor.colour.value_or(kFloor);
  scene_.sky = kSky;
  scene_.image = {world::image_size(world), world.floor.pixels};
  for (const world::FloorPiece& piece : world::patches_of(world)) {
    scene_.patches.push_back({world::outline_of(piece, kRoundPatch), piece.colour});
  }
  for (const world::Lamp& lamp : world.lamps) {
    add(scene_, Shape::sphere(world::kLampRadius), {.origin = {lamp.x, lamp.y, lamp.z}},
        lamp.colour);
  }
  for (const world::Fixture& wall : world::walls_of(world.arena)) {
    add(scene_, wall.shape, wall.frame, colours.wall);
  }
  for (const world::Charger& charger : world.chargers) {
    const world::Fixture fixture = world::fixture_of(charger);
    if (charger.seen_by_range_sensors) {
      add(scene_, fixture.shape, fixture.frame, world::kChargerColour);
    } else {
      scene_.marks.push_back(
          {{charger.x, charger.y}, fixture.shape.radius(), world::kChargerColour});
    }
  }
  for (const world::Obstacle& box : world.obstacles) {
    world::Fixture fixture = world::fixture_of(box);
    boxes_.push_back(add(scene_, fixture.shape, {.origin = {0.0, 0.0, 0.5 * fixture.shape.size.z}},
                         world::box_colour(world, box, colours)));
    fixture.frame.origin = {box.x, box.y, box.z};
    put(scene_, boxes_.back(), fixture.frame);
  }
  for (const world::Robot& robot : world.robots) {
    const bool is_grey = viewer == Viewer::camera && !robot.colour;
    add_robot(robot, is_grey ? kChassis : world::robot_colour(world, robot), colours.tyre);
  }
  lights_from_ = scene_.balls.size();
}

void WorldScene::add_robot(const world::Robot& robot, const Colour& colour, const Colour& tyre) {
  const std::size_t index = robots_.size();
  const BodyPlan plan = world::plan_of(robot);
  std::vector<Body>& vehicles = robots_.emplace_back(plan.vehicles());
  for (const Part& part : plan.parts) {
    if (part.role == PartRole::caster) continue;  // out of sight below the chassis
    const Body made =
        add(scene_, part.shape, part.frame, part.role == PartRole::wheel ? tyre : colour, index);
    Body& vehicle = vehicles[part.vehicle];
    vehicle.insert(vehicle.end(), made.begin(), made.end());
  }
  const Frame start = Frame::turned({robot.x, robot.y, robot.z}, radians(robot.heading_deg), 0.0);
  const std::vector<Frame> frames = world::in_line(plan);
  for (std::size_t i = 0; i < frames.size(); ++i) put(scene_, vehicles[i], start.frame(frames[i]));
}

void WorldScene::place_robot(std::size_t robot, const Frame& frame) {
  put(scene_, robots_.at(robot).front(), frame);
}

void WorldScene::place_segment(std::size_t robot, std::size_t segment, const Frame& frame) {
  put(scene_, robots_.at(robot).at(segment + 1), frame);
}

void WorldScene::show_lights(std::span<const simulation::CarriedLight> lights) {
  constexpr double kRadius = 0.01;  // m
  scene_.balls.resize(lights_from_);
  for (const simulation::CarriedLight& light : lights) {
    scene_.balls.push_back({light.place, kRadius, light.colour, light.robot});
  }
}

void WorldScene::place_box(std::size_t box, const std::optional<Frame>& frame) {
  put(scene_, boxes_.at(box), frame);
}

}  // namespace elsie::render

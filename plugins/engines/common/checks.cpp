#include "checks.h"

#include <cmath>
#include <stdexcept>

#include "elsie/world/parts.h"

#include "softness.h"

namespace elsie::physics {

void require(bool holds, const std::string& sentence) {
  if (!holds) throw std::invalid_argument(sentence);
}

namespace {

bool is_positive(double value) { return std::isfinite(value) && value > 0.0; }

}  // namespace

void check(const world::Arena& arena, const world::Physics& physics) {
  require(is_positive(arena.length) && is_positive(arena.width),
          "The arena's length and width must be positive and finite.");
  require(!arena.walls || (is_positive(arena.wall_height) && is_positive(arena.wall_thickness)),
          "The height and thickness of the arena's walls must be positive and finite.");
  require(is_positive(physics.step), "The step of the physics must be positive and finite.");
  require(std::isfinite(physics.gravity), "Gravity must be finite.");
  const auto [erp, cfm, from_spring] = softness_of(physics);
  require(erp > 0.0 && erp <= 1.0, "The error reduction (erp) of the physics must be in (0, 1].");
  require(std::isfinite(cfm) && cfm >= 0.0,
          "The constraint force mixing (cfm) of the physics must be finite and not negative.");
  require(std::isfinite(physics.friction) && physics.friction >= 0.0 &&
              std::isfinite(physics.wheel_slip) && physics.wheel_slip >= 0.0,
          "Friction and wheel slip must be finite and not negative.");
  require(physics.bounce >= 0.0 && physics.bounce <= 1.0, "Bounce must be in [0, 1].");
}

void check(const Pose& pose, double z) {
  require(std::isfinite(pose.x + pose.y + pose.heading_rad + z),
          "The pose of a robot must be finite.");
}

void check(const world::Obstacle& box) {
  const auto problem = world::problem_of(box);
  require(!problem, std::string("A ") + box.shape_name() + " " + problem.value_or(""));
  const Vector3 size = world::fixture_of(box).shape.size;
  require(is_positive(size.x) && is_positive(size.y) && is_positive(size.z),
          "The length, width, radius and height of a box must be positive and finite.");
  require(!box.is_dynamic() || is_positive(box.mass),
          "The mass of a box that can be pushed must be positive and finite.");
  require(box.hands >= 1, "A box needs at least one hand.");
  require(std::isfinite(box.x + box.y + box.z + box.heading_deg),
          "The place and heading of a box must be finite.");
}

void check(std::span<const JointSetting> settings, std::size_t joints) {
  require(settings.size() == joints,
          "A robot needs one setting for each joint with a motor or steering.");
  double sum = 0.0;
  for (const JointSetting& setting : settings) {
    sum += setting.rate_rad_s + setting.angle_rad + setting.turn_rad_s;
  }
  require(std::isfinite(sum),
          "The rates and angles that a robot's joints are to hold must be finite.");
}

void check_hold(world::ObstacleKind kind, bool is_present, int holders, int hands) {
  require(kind == world::ObstacleKind::dynamic && is_present,
          "Only a box that can be pushed can be held.");
  require(holders < hands, "As many robots hold the box as can.");
}

void check_drive(world::ObstacleKind kind, const Vector2& position, const Vector2& velocity) {
  require(kind == world::ObstacleKind::moving, "Only a moving box can be driven.");
  require(std::isfinite(position.x + position.y + velocity.x + velocity.y),
          "The position and velocity of a moving box must be finite.");
}

}  // namespace elsie::physics

#include "elsie/world/parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "elsie/world/footprint.h"

#include "differential.h"
#include "obstacle_shapes.h"

namespace elsie::world {
namespace {

Fixture upright(Fixture::Kind kind, std::size_t index, const Vector3& bottom, double heading_rad,
                const Shape& shape) {
  const Vector3 middle{bottom.x, bottom.y, bottom.z + 0.5 * shape.size.z};
  return {kind, index, shape, Frame::turned(middle, heading_rad, 0.0)};
}

Part chassis_part(const Shape& shape, double clearance, double mass) {
  return {"chassis",   PartRole::chassis,
          shape,       {.origin = {0.0, 0.0, clearance + 0.5 * shape.size.z}},
          mass,        0,
          FixedJoint{}};
}

BodyPlan unchecked_plan(const Chassis& chassis, Drive& drive) {
  BodyPlan plan;
  plan.parts.push_back(
      chassis_part(chassis.round ? Shape::pillar(0.5 * chassis.length, chassis.height)
                                 : Shape::box({chassis.length, chassis.width, chassis.height}),
                   chassis.clearance, chassis.mass));
  drive.build(chassis, plan);
  return plan;
}

void add_segments(BodyPlan& plan, std::span<const Segment> segments) {
  const std::vector<Coupling> chain = couplings(plan, segments);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const std::size_t vehicle = plan.vehicles();
    std::vector<Part> parts = parts_of(segments[i]);
    parts[0].joint = HitchJoint(chain[i]);
    for (Part& part : parts) {
      part.name = segments[i].id + "/" + part.name;
      part.vehicle = vehicle;
      plan.parts.push_back(std::move(part));
    }
  }
}

}  // namespace

std::vector<Fixture> walls_of(const Arena& arena) {
  if (!arena.walls) return {};
  const double t = arena.wall_thickness;
  const double x = 0.5 * (arena.length + t), y = 0.5 * (arena.width + t);
  const Shape across = Shape::box({t, arena.width, arena.wall_height});
  const Shape along = Shape::box({arena.length + 2.0 * t, t, arena.wall_height});
  const auto wall = [](std::size_t index, double at_x, double at_y, const Shape& shape) {
    return upright(Fixture::Kind::wall, index, {at_x, at_y, 0.0}, 0.0, shape);
  };
  return {wall(0, x, 0.0, across), wall(1, 0.0, y, along), wall(2, -x, 0.0, across),
          wall(3, 0.0, -y, along)};
}

Fixture fixture_of(const Obstacle& obstacle, std::size_t index) {
  return upright(Fixture::Kind::obstacle, index, {obstacle.x, obstacle.y, obstacle.z},
                 radians(obstacle.heading_deg), form_of(obstacle.shape).solid(obstacle));
}

Fixture fixture_of(const Charger& charger, std::size_t index) {
  constexpr double edge = Charger::kBoxEdge;
  return upright(Fixture::Kind::charger, index, {charger.x, charger.y, 0.0}, 0.0,
                 charger.seen_by_range_sensors ? Shape::box({edge, edge, edge})
                                               : Shape::pillar(charger.radius, 0.0));
}

Chassis chassis_of(const RobotBody& body) {
  return {.round = body.round,
          .length = body.length,
          .width = body.width,
          .height = body.height,
          .clearance = body.clearance,
          .mass = body.mass,
          .wheel_radius = body.wheel_radius,
          .wheel_width = body.wheel_width,
          .half_axle = body.half_axle(),
          .wheel_mass = body.wheel_mass,
          .wheel_torque = body.wheel_torque};
}

std::vector<Part> parts_of(const Segment& d) {
  std::vector<Part> parts{
      chassis_part(Shape::box({d.length, d.width, d.height}), d.clearance, d.mass)};
  add_wheels(parts, Shape::wheel(d.wheel_radius, d.wheel_width), d.half_axle(), 0.0, {});
  return parts;
}

BodyPlan plan_of(const Chassis& chassis, Drive& drive) {
  BodyPlan plan = unchecked_plan(chassis, drive);
  check(plan);
  if (std::none_of(plan.parts.begin(), plan.parts.end(),
                   [](const Part& part) { return can_be_set(part.joint); })) {
    throw std::invalid_argument(
        "A drive must have a joint that it can set: a wheel with a motor or with steering, or a "
        "joint between two vehicles with a motor.");
  }
  return plan;
}

BodyPlan plan_of(const RobotBody& body, std::span<const Segment> segments) {
  Differential differential;
  BodyPlan plan = unchecked_plan(chassis_of(body), differential);
  add_segments(plan, segments);
  return plan;
}

BodyPlan driven_plan(const Robot& robot) {
  return robot.driven.parts.empty() ? plan_of(robot.body, {}) : robot.driven;
}

BodyPlan plan_of(const Robot& robot) {
  BodyPlan plan = driven_plan(robot);
  add_segments(plan, robot.segments);
  return plan;
}

std::vector<Frame> in_line(const BodyPlan& plan) {
  std::vector<Frame> frames;
  double place = 0.0;
  for (const Part& part : plan.parts) {
    if (part.vehicle < frames.size()) continue;  // not the first part of its vehicle
    if (const auto* hitch = std::get_if<HitchJoint>(&part.joint)) {
      place += hitch->behind + hitch->ahead;
    }
    frames.push_back({.origin = {-place, 0.0, 0.0}});
  }
  return frames;
}

std::span<const Part> vehicle_of(const BodyPlan& plan, std::size_t vehicle) {
  const auto of_vehicle = [&](const Part& part) { return part.vehicle == vehicle; };
  const auto first = std::find_if(plan.parts.begin(), plan.parts.end(), of_vehicle);
  return {first, std::find_if_not(first, plan.parts.end(), of_vehicle)};
}

Vector3 reach_of(const Part& part) {
  const Vector3 half = 0.5 * part.shape.size;
  const auto& [origin, forward, left, up] = part.frame;
  const auto along = [&](double f, double l, double u) {
    return std::abs(f) * half.x + std::abs(l) * half.y + std::abs(u) * half.z;
  };
  const auto* wheel = std::get_if<WheelJoint>(&part.joint);
  if (wheel && wheel->steered) {
    const double around = std::hypot(half.x, half.y);
    return {around, around, half.z};
  }
  return {along(forward.x, left.x, up.x), along(forward.y, left.y, up.y),
          along(forward.z, left.z, up.z)};
}

double farthest_of(const Part& part, const Vector3& middle) {
  if (part.shape.is_round()) return std::hypot(middle.x, middle.y) + part.shape.radius();
  const Vector3 reach = reach_of(part);
  return std::hypot(std::abs(middle.x) + reach.x, std::abs(middle.y) + reach.y);
}

}  // namespace elsie::world

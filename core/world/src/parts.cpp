#include "elsie/world/parts.h"

#include <string>

#include "elsie/world/train.h"

#include "differential.h"

namespace elsie::world {
namespace {

Fixture upright(Fixture::Kind kind, std::size_t index, const Vector3& bottom, double heading_rad,
                const Shape& shape) {
  const Vector3 middle{bottom.x, bottom.y, bottom.z + 0.5 * shape.size.z};
  return {kind, index, shape, Frame::turned(middle, heading_rad, 0.0)};
}

Part chassis_part(const std::string& name, const Vector3& size, double clearance, double mass) {
  return {name,
          PartRole::chassis,
          Shape::box(size),
          {.origin = {0.0, 0.0, clearance + 0.5 * size.z}},
          mass,
          0,
          FixedJoint{}};
}

BodyPlan unchecked_plan(const Chassis& chassis, Drive& drive) {
  BodyPlan plan;
  plan.parts.push_back(chassis_part("chassis", {chassis.length, chassis.width, chassis.height},
                                    chassis.clearance, chassis.mass));
  drive.build(chassis, plan);
  return plan;
}

/// A segment: a chassis on a joint, and two wheels that roll freely, flush with its sides.
void add_segment(BodyPlan& plan, const Segment& d, const Coupling& c) {
  const std::size_t vehicle = plan.vehicles();
  const std::string prefix = d.id + "/";
  Part& chassis = plan.parts.emplace_back(
      chassis_part(prefix + "chassis", {d.length, d.width, d.height}, d.clearance, d.mass));
  chassis.vehicle = vehicle;
  chassis.joint = HitchJoint{c.behind, c.ahead, c.height, c.max_yaw_rad, c.max_pitch_rad};
  for (const bool left : {true, false}) {
    plan.parts.push_back({prefix + (left ? "left_wheel" : "right_wheel"),
                          PartRole::wheel,
                          Shape::wheel(d.wheel_radius, d.wheel_width),
                          {.origin = {0.0, (left ? 1.0 : -1.0) * d.half_axle(), d.wheel_radius}},
                          0.0,
                          vehicle,
                          WheelJoint{}});
  }
}

void add_segments(BodyPlan& plan, std::span<const Segment> segments) {
  const std::vector<Coupling> chain = couplings_behind(plan, segments);
  for (std::size_t i = 0; i < chain.size(); ++i) add_segment(plan, segments[i], chain[i]);
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

Fixture fixture_of(const Box& box, std::size_t index) {
  return upright(Fixture::Kind::box, index, {box.x, box.y, box.z}, radians(box.heading_deg),
                 Shape::box({box.length, box.width, box.height}));
}

Fixture fixture_of(const Charger& charger, std::size_t index) {
  constexpr double edge = Charger::kBoxEdge;
  return upright(Fixture::Kind::charger, index, {charger.x, charger.y, 0.0}, 0.0,
                 charger.seen_by_range_sensors ? Shape::box({edge, edge, edge})
                                               : Shape::pillar(charger.radius, 0.0));
}

std::vector<Fixture> fixtures_of(const World& world) {
  std::vector<Fixture> all = walls_of(world.arena);
  for (std::size_t i = 0; i < world.boxes.size(); ++i) {
    all.push_back(fixture_of(world.boxes[i], i));
  }
  for (std::size_t i = 0; i < world.chargers.size(); ++i) {
    all.push_back(fixture_of(world.chargers[i], i));
  }
  return all;
}

Chassis chassis_of(const RobotBody& body) {
  return {.length = body.length,
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

BodyPlan plan_of(const Chassis& chassis, Drive& drive) {
  BodyPlan plan = unchecked_plan(chassis, drive);
  check(plan);
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
    if (part.vehicle < frames.size()) continue;  // not the first of its vehicle
    if (const auto* hitch = std::get_if<HitchJoint>(&part.joint)) {
      place += hitch->behind + hitch->ahead;
    }
    frames.push_back({.origin = {-place, 0.0, 0.0}});
  }
  return frames;
}

}  // namespace elsie::world

#include "elsie/world/parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "elsie/world/engine_facts.h"
#include "elsie/world/train.h"

namespace elsie::world {
namespace {

Fixture upright(Fixture::Kind kind, std::size_t index, const Vector3& bottom, double heading_rad,
                const Shape& shape) {
  const Vector3 middle{bottom.x, bottom.y, bottom.z + 0.5 * shape.size.z};
  return {kind, index, shape, Frame::turned(middle, heading_rad, 0.0)};
}

/// The chassis of a vehicle, and two wheels flush with its sides or outside of them.
template <class Vehicle>
std::vector<Part> chassis_on_wheels(const Vehicle& d, const Shape& chassis, const WheelJoint& wheel,
                                    double wheel_mass) {
  std::vector<Part> parts{{"chassis",
                           PartRole::chassis,
                           chassis,
                           {.origin = {0.0, 0.0, d.clearance + 0.5 * d.height}},
                           d.mass,
                           0,
                           FixedJoint{}}};
  for (const bool left : {true, false}) {
    parts.push_back({left ? "left_wheel" : "right_wheel",
                     PartRole::wheel,
                     Shape::wheel(d.wheel_radius, d.wheel_width),
                     {.origin = {0.0, (left ? 1.0 : -1.0) * d.half_axle(), d.wheel_radius}},
                     wheel_mass,
                     0,
                     wheel});
  }
  return parts;
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

std::vector<Part> parts_of(const RobotBody& body) {
  std::vector<Part> parts =
      chassis_on_wheels(body,
                        body.round ? Shape::pillar(0.5 * body.length, body.height)
                                   : Shape::box({body.length, body.width, body.height}),
                        {.torque = body.wheel_torque}, body.wheel_mass);
  const double radius = caster_radius(body);
  for (const bool front : {true, false}) {
    parts.push_back({front ? "front_caster" : "rear_caster",
                     PartRole::caster,
                     Shape::sphere(radius),
                     {.origin = {(front ? 1.0 : -1.0) * half_base(body), 0.0, radius}},
                     kCasterMass * body.mass,
                     0,
                     CasterJoint{}});
  }
  return parts;
}

std::vector<Part> parts_of(const Segment& segment) {
  return chassis_on_wheels(segment, Shape::box({segment.length, segment.width, segment.height}), {},
                           0.0);
}

BodyPlan plan_of(const RobotBody& body, std::span<const Segment> segments) {
  BodyPlan all{parts_of(body)};
  const std::vector<Coupling> chain = couplings(body, segments);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Coupling& c = chain[i];
    std::vector<Part> parts = parts_of(segments[i]);
    parts[0].joint = HitchJoint{c.behind, c.ahead, c.height, c.max_yaw_rad, c.max_pitch_rad};
    for (Part& part : parts) {
      part.name = segments[i].id + "/" + part.name;
      part.vehicle = i + 1;
      all.parts.push_back(std::move(part));
    }
  }
  return all;
}

BodyPlan plan_of(const Robot& robot) { return plan_of(robot.body, robot.segments); }

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

#include "narrow_phase.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "prism_contact.h"

namespace elsie::physics {
namespace {

// A body that was stopped at a surface stands there to within rounding and the softness of
// contacts.
constexpr double kTouching = 2e-5;  // m

// A body counts as upright up to about 6 degrees.
constexpr double kUpright = 0.995;

struct Span {
  double lower, upper;
};

Span height_of(const Solid& solid) {
  const OrientedBox& s = solid.shape;
  // Of a wheel, the height of the cylinder; the box around it turns with the chassis, not with it.
  const double up = s.half.z * std::abs(s.axes[2].z);
  return {s.center.z - up, s.center.z + up};
}

bool is_upright(const Solid& solid) { return solid.shape.axes[2].z > kUpright; }

Rectangle seen_from_above(const OrientedBox& box) {
  const double level = std::hypot(box.axes[0].x, box.axes[0].y);
  return {{box.center.x, box.center.y},
          {box.axes[0].x / level, box.axes[0].y / level},
          box.half.x,
          box.half.y};
}

Vector3 velocity_at(const Solid& solid, const Vector3& point) {
  if (!solid.body) return {};
  return to_vector(dBodyGetLinearVel(solid.body)) +
         cross(to_vector(dBodyGetAngularVel(solid.body)),
               point - to_vector(dBodyGetPosition(solid.body)));
}

/// As fast as the two can come together anywhere.
double greatest_closing_speed(const Solid& a, const Solid& b) {
  double speed = 0.0;
  for (const Solid* solid : {&a, &b}) {
    if (!solid->body) continue;
    const Vector3 v = to_vector(dBodyGetLinearVel(solid->body));
    const dReal* w = dBodyGetAngularVel(solid->body);
    const Vector3& half = solid->shape.half;
    speed += std::hypot(v.x, v.y) + std::abs(w[2]) * (half.x + half.y);
  }
  return speed;
}

bool meet_in_space(OdeContacts& contacts, const Solid& a, const Solid& b) {
  std::array<dContactGeom, 8> found;
  const int count =
      dCollide(a.geom, b.geom, static_cast<int>(found.size()), found.data(), sizeof(dContactGeom));
  for (int i = 0; i < count; ++i) {
    contacts.between(a.body, b.body, found[static_cast<std::size_t>(i)]);
  }
  return count > 0;
}

/// Two upright bodies side by side.
bool meet_in_plane(OdeContacts& contacts, const Solid& a, const Solid& b, const Span& common,
                   const PlanarManifold& manifold) {
  // A wheel stands out furthest at the height of its axle. Flat faces meet along their whole
  // height, so that neither tips over the other.
  std::array<double, 2> heights{common.lower, common.upper};
  std::size_t levels = common.upper - common.lower > 1e-3 ? 2 : 1;
  for (const Solid* solid : {&a, &b}) {
    if (solid->kind == SolidKind::wheel) {
      heights[0] = solid->shape.center.z;
      levels = 1;
    }
  }
  const Vector3 normal{manifold.normal.x, manifold.normal.y, 0.0};
  bool touch = false;
  for (int i = 0; i < manifold.count; ++i) {
    const PlanarContact& contact = manifold.points[static_cast<std::size_t>(i)];
    touch = touch || contact.gap <= kTouching;
    const Vector3 middle{contact.point.x, contact.point.y, 0.5 * (common.lower + common.upper)};
    const double closing = -dot(normal, velocity_at(a, middle) - velocity_at(b, middle));
    if (contact.gap > contacts.margin(closing)) continue;
    for (std::size_t k = 0; k < levels; ++k) {
      contacts.between(a.body, b.body, {middle.x, middle.y, heights[k]}, normal, contact.gap);
    }
  }
  return touch;
}

std::array<Solid, 3> solids_of(const OdeRobot& robot) {
  const auto wheel = [&](OdeRobot::Part part, const Cylinder& c) {
    return Solid{robot.body(part),
                 robot.geom(part),
                 SolidKind::wheel,
                 {c.center, robot.chassis_box().axes, {c.radius, c.half_length, c.radius}}};
  };
  return {Solid{robot.body(OdeRobot::chassis), robot.geom(OdeRobot::chassis), SolidKind::box,
                robot.chassis_box()},
          wheel(OdeRobot::left_wheel, robot.wheels()[0]),
          wheel(OdeRobot::right_wheel, robot.wheels()[1])};
}

}  // namespace

bool meet_solids(OdeContacts& contacts, const Solid& a, const Solid& b) {
  if (!is_upright(a) || !is_upright(b)) return meet_in_space(contacts, a, b);
  const Span of_a = height_of(a), of_b = height_of(b);
  const Span common{std::max(of_a.lower, of_b.lower), std::min(of_a.upper, of_b.upper)};
  if (common.upper <= common.lower) return false;
  for (const Solid* solid : {&a, &b}) {
    const double axle = solid->shape.center.z;
    const bool low = axle < common.lower || axle > common.upper;
    if (solid->kind == SolidKind::wheel && low) return meet_in_space(contacts, a, b);
  }
  const PlanarManifold manifold = meet(seen_from_above(a.shape), seen_from_above(b.shape),
                                       contacts.margin(greatest_closing_speed(a, b)));
  if (manifold.count == 0) return false;
  // Further into each other from the side than from above: one stands on the other.
  const double depth = -std::min(manifold.points[0].gap,
                                 manifold.points[static_cast<std::size_t>(manifold.count) - 1].gap);
  const double lesser_height = std::min(of_a.upper - of_a.lower, of_b.upper - of_b.lower);
  const double overlap = common.upper - common.lower;
  if (overlap < depth && overlap < 0.5 * lesser_height) return meet_in_space(contacts, a, b);
  return meet_in_plane(contacts, a, b, common, manifold);
}

bool meet_robots(OdeContacts& contacts, const OdeRobot& a, const OdeRobot& b) {
  bool touch = false;
  for (const Solid& x : solids_of(a)) {
    for (const Solid& y : solids_of(b)) touch = meet_solids(contacts, x, y) || touch;
  }
  return touch;
}

bool meet_robot_and_box(OdeContacts& contacts, const OdeRobot& robot, const Solid& box) {
  bool touch = false;
  const std::array<Solid, 3> parts = solids_of(robot);
  for (const Solid& part : parts) touch = meet_solids(contacts, part, box) || touch;
  // The casters lie below the chassis; only what passes below it, or lies under a robot that has
  // been tipped over, meets them.
  const bool upright = is_upright(parts[0]);
  if (upright && height_of(box).upper > height_of(parts[0]).lower + 1e-3) return touch;
  for (const OdeRobot::Part part : {OdeRobot::front_caster, OdeRobot::rear_caster}) {
    const Solid caster{robot.body(part), robot.geom(part), SolidKind::box, {}};
    touch = meet_in_space(contacts, caster, box) || touch;
  }
  return touch;
}

}  // namespace elsie::physics

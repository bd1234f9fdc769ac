#include "narrow_phase.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "prism_contact.h"

namespace elsie::physics {
namespace {

// A body that rises less than this above the bottom of a box passes below it.
constexpr double kBelow = 1e-3;  // m

// A body counts as upright up to about 6 degrees.
constexpr double kUpright = 0.995;

struct Span {
  double lower, upper;
};

Span height_of(const Solid& solid) {
  const OrientedBox& s = solid.shape;
  // For a wheel, the height of the cylinder: its box turns with the chassis, not with the wheel.
  const double up = s.half.z * std::abs(s.axes[2].z);
  return {s.center.z - up, s.center.z + up};
}

/// True if it meets other upright bodies in the plane. A ball always does, a capsule never.
bool is_upright(const Solid& solid) {
  return solid.kind != SolidKind::capsule && solid.shape.axes[2].z > kUpright;
}

/// True if it is widest at the height of its middle.
bool bulges(const Solid& solid) {
  return solid.kind == SolidKind::wheel || solid.kind == SolidKind::ball;
}

std::variant<Rectangle, Disc, Polygon> seen_from_above(const Solid& solid) {
  const OrientedBox& box = solid.shape;
  if (solid.kind == SolidKind::pillar || solid.kind == SolidKind::ball) {
    return Disc{{box.center.x, box.center.y}, box.half.x};
  }
  const double level = std::hypot(box.axes[0].x, box.axes[0].y);
  if (solid.kind == SolidKind::prism) {
    Polygon polygon{{box.center.x, box.center.y}, {}, solid.outline.size()};
    const double c = box.axes[0].x / level, s = box.axes[0].y / level;
    std::transform(solid.outline.begin(), solid.outline.end(), polygon.corners.begin(),
                   [&](const Vector2& corner) {
                     return Vector2{c * corner.x - s * corner.y, s * corner.x + c * corner.y};
                   });
    return polygon;
  }
  return Rectangle{{box.center.x, box.center.y},
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

/// The highest speed at which any points of the two can approach each other, m/s.
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

/// Two upright bodies, one next to the other.
bool meet_in_plane(OdeContacts& contacts, const Solid& a, const Solid& b, const Span& common,
                   const PlanarManifold& manifold) {
  // A wheel reaches furthest at the height of its axle. Upright faces meet along their whole
  // height, so that neither body tips over the other.
  std::array<double, 2> heights{common.lower, common.upper};
  std::size_t levels = common.upper - common.lower > 1e-3 ? 2 : 1;
  for (const Solid* solid : {&a, &b}) {
    if (bulges(*solid)) {
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

/// The height of the upper or lower end of an upright body above a place.
double end_above(const Solid& solid, double end, const Vector2& place) {
  const Vector3& up = solid.shape.axes[2];
  const Vector3 middle = solid.shape.center + end * solid.shape.half.z * up;
  return middle.z - (up.x * (place.x - middle.x) + up.y * (place.y - middle.y)) / up.z;
}

/// One upright body stands on another: contacts at the corners of the area on which it stands.
bool stand(OdeContacts& contacts, const Solid& a, const Solid& b) {
  const bool a_is_above = a.shape.center.z > b.shape.center.z;
  const Solid &upper = a_is_above ? a : b, &lower = a_is_above ? b : a;
  const auto polygon = [](const Solid& solid) {
    return std::visit([](const auto& outline) { return polygon_of(outline); },
                      seen_from_above(solid));
  };
  bool touch = false;
  for (const Vector2& place : common_area(polygon(upper), polygon(lower))) {
    const double top = end_above(lower, 1.0, place);
    const double gap = end_above(upper, -1.0, place) - top;
    if (gap > contacts.margin(0.0)) continue;
    touch = touch || gap <= kTouching;
    contacts.between(upper.body, lower.body, {place.x, place.y, top + 0.5 * gap}, {0.0, 0.0, 1.0},
                     gap);
  }
  return touch;
}

/// True if the wheels can meet a body that reaches up to this height.
bool wheels_count(const Vehicle& vehicle, double top) {
  return !vehicle.wheels_inside || !is_upright(vehicle.chassis) ||
         top <= height_of(vehicle.chassis).lower + kBelow;
}

bool meet_vehicle_with(OdeContacts& contacts, const Solid& solid, const Vehicle& vehicle,
                       bool with_wheels) {
  bool touch = meet_solids(contacts, solid, vehicle.chassis);
  if (with_wheels) {
    for (const Solid& wheel : vehicle.wheels) {
      touch = meet_solids(contacts, solid, wheel) || touch;
    }
  }
  return touch;
}

double top_of(const Vehicle& vehicle) {
  double top = height_of(vehicle.chassis).upper;
  for (const Solid& wheel : vehicle.wheels) top = std::max(top, height_of(wheel).upper);
  return top;
}

}  // namespace

bool meet_solids(OdeContacts& contacts, const Solid& a, const Solid& b) {
  if (!is_upright(a) || !is_upright(b)) return meet_in_space(contacts, a, b);
  const Span of_a = height_of(a), of_b = height_of(b);
  const Span common{std::max(of_a.lower, of_b.lower), std::min(of_a.upper, of_b.upper)};
  if (common.upper <= common.lower) return false;
  for (const Solid* solid : {&a, &b}) {
    const double middle = solid->shape.center.z;
    const bool low = middle < common.lower || middle > common.upper;
    if (bulges(*solid) && low) return meet_in_space(contacts, a, b);
  }
  const double margin = contacts.margin(greatest_closing_speed(a, b));
  const PlanarManifold manifold = std::visit(
      [&](const auto& from_a, const auto& from_b) { return meet(from_a, from_b, margin); },
      seen_from_above(a), seen_from_above(b));
  if (manifold.count == 0) return false;
  // The overlap is larger from the side than from above: one body stands on the other.
  const double depth = -std::min(manifold.points[0].gap,
                                 manifold.points[static_cast<std::size_t>(manifold.count) - 1].gap);
  const double lesser_height = std::min(of_a.upper - of_a.lower, of_b.upper - of_b.lower);
  const double overlap = common.upper - common.lower;
  if (overlap < depth && overlap < 0.5 * lesser_height) {
    const bool is_prism = a.kind == SolidKind::prism || b.kind == SolidKind::prism;
    return is_prism && !bulges(a) && !bulges(b) ? stand(contacts, a, b)
                                                : meet_in_space(contacts, a, b);
  }
  return meet_in_plane(contacts, a, b, common, manifold);
}

bool meet_vehicles(OdeContacts& contacts, const Vehicle& a, const Vehicle& b) {
  const bool wheels_of_b = wheels_count(b, top_of(a));
  bool touch = meet_vehicle_with(contacts, a.chassis, b, wheels_of_b);
  if (wheels_count(a, top_of(b))) {
    for (const Solid& wheel : a.wheels) {
      touch = meet_vehicle_with(contacts, wheel, b, wheels_of_b) || touch;
    }
  }
  return touch;
}

bool meet_vehicle_and_box(OdeContacts& contacts, const Vehicle& vehicle, const Solid& box) {
  bool touch = meet_solids(contacts, vehicle.chassis, box);
  const double top = height_of(box).upper;
  if (wheels_count(vehicle, top)) {
    for (const Solid& wheel : vehicle.wheels) touch = meet_solids(contacts, wheel, box) || touch;
  }
  // The casters lie below the chassis. Only a body that passes below it, or lies under a robot that
  // has tipped over, meets them.
  if (is_upright(vehicle.chassis) && top > height_of(vehicle.chassis).lower + kBelow) return touch;
  for (const Solid& caster : vehicle.casters) {
    touch = meet_in_space(contacts, caster, box) || touch;
  }
  return touch;
}

}  // namespace elsie::physics

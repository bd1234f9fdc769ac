#include "ode_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace elsie::physics {
namespace {

// Rubber tyres have more grip than chassis and boxes; otherwise no robot could push a box of its
// own weight.
constexpr double kTyreGrip = 3.0;

// The sine of a tilt up to which the end of a cylinder counts as level.
constexpr double kLevel = 1e-3;

dContact contact_at(const Vector3& point, const Vector3& normal, double friction) {
  dContact contact{};
  contact.surface.mu = friction;
  contact.geom.pos[0] = point.x;
  contact.geom.pos[1] = point.y;
  contact.geom.pos[2] = point.z;
  contact.geom.normal[0] = normal.x;
  contact.geom.normal[1] = normal.y;
  contact.geom.normal[2] = normal.z;
  return contact;
}
dContact on_floor(const Vector3& point, double friction) {
  return contact_at(point, {0.0, 0.0, 1.0}, friction);
}

}  // namespace

OdeContacts::OdeContacts(const world::Physics& physics)
    : step_(physics.step),
      gravity_(std::abs(physics.gravity)),
      friction_(physics.friction),
      tyre_friction_(kTyreGrip * physics.friction),
      slip_(physics.wheel_slip),
      bounce_(physics.bounce),
      bounce_threshold_(2.0 * gravity_ * step_) {}

double OdeContacts::margin(double speed) const {
  // A body must hit before it can bounce.
  if (bounce_ > 0.0 && speed > bounce_threshold_) return 0.0;
  return kSlack + (std::max(0.0, speed) + gravity_ * step_) * step_;
}

void OdeContacts::attach(dBodyID a, dBodyID b, dContact& contact, double gap) {
  dSurfaceParameters& surface = contact.surface;
  surface.mode |= dContactApprox1 | dContactSoftCFM;
  contact.geom.depth = std::max(0.0, -gap);
  if (gap > 0.0) {
    surface.mode |= dContactMotionN;
    surface.motionN = -gap / step_;
  } else if (bounce_ > 0.0) {
    surface.mode |= dContactBounce;
    surface.bounce = bounce_;
    surface.bounce_vel = bounce_threshold_;
  }
  found_.push_back({a, b, a ? dBodyGetData(a) : nullptr, b ? dBodyGetData(b) : nullptr, contact, nullptr});
}

void OdeContacts::wheel_on_floor(dBodyID body, dGeomID geom, const Cylinder& wheel, double sinking,
                                 const WheelJoint& joint, dGeomID floor) {
  // The rolling radius and the track are exact when a wheel touches the floor in one point, the
  // lowest of its middle disc.
  const Vector3& axis = wheel.axis;
  const double level = std::sqrt(axis.x * axis.x + axis.y * axis.y);
  if (level <= 0.99) {  // it is tipped over
    std::array<dContactGeom, 4> found;
    const int count =
        dCollide(geom, floor, static_cast<int>(found.size()), found.data(), sizeof(dContactGeom));
    for (int k = 0; k < count; ++k) {
      between(body, nullptr, found[static_cast<std::size_t>(k)]);
    }
    return;
  }
  const Vector3 down = (1.0 / level) * Vector3{axis.x * axis.z, axis.y * axis.z, -level * level};
  const Vector3 lowest = wheel.center + wheel.radius * down;
  if (lowest.z > margin(sinking)) return;
  // The direction in which it rolls.
  const Vector3 ahead{axis.y / level, -axis.x / level, 0.0};
  const bool is_driven = joint.torque > 0.0;
  const bool holds_ahead = is_driven && !joint.rollers_rad;
  dContact contact = on_floor(lowest, holds_ahead ? tyre_friction_ : 0.0);
  contact.surface.mode = dContactFDir1 | dContactSlip2;
  contact.surface.slip2 = slip_;
  Vector3 glides = ahead;  // no friction, unless a motor holds it
  if (holds_ahead) {
    contact.surface.mode |= dContactSlip1;
    contact.surface.slip1 = slip_;
  } else {
    contact.surface.mode |= dContactMu2;
    contact.surface.mu2 = tyre_friction_;
  }
  if (joint.rollers_rad) {
    // Across the axles of the rollers.
    const double c = std::cos(*joint.rollers_rad), s = std::sin(*joint.rollers_rad);
    glides = {s * ahead.x + c * ahead.y, s * ahead.y - c * ahead.x, 0.0};
  }
  contact.fdir1[0] = glides.x;
  contact.fdir1[1] = glides.y;
  attach(body, nullptr, contact, lowest.z);
}

void OdeContacts::caster_on_floor(dBodyID caster, const Vector3& lowest) {
  dContact contact = on_floor(lowest, 0.0);
  attach(caster, nullptr, contact, lowest.z);
}

/// The height above the floor from which a point of a body of this size can reach it in this step.
double OdeContacts::floor_reach(dBodyID body, const Vector3& half) const {
  const Vector3 w = to_vector(dBodyGetAngularVel(body));
  // The highest speed at which any corner can sink.
  const double size = half.x + half.y + half.z;
  return margin(-dBodyGetLinearVel(body)[2] + size * (std::abs(w.x) + std::abs(w.y)));
}

void OdeContacts::box_on_floor(dBodyID body, const OrientedBox& box) {
  const auto& [a, b, c] = box.axes;
  const Vector3& half = box.half;
  const double reach = floor_reach(body, half);
  const double lowest =
      box.center.z - std::abs(a.z) * half.x - std::abs(b.z) * half.y - std::abs(c.z) * half.z;
  if (lowest > reach) return;
  // The upper corners of a flat box come near the floor as well, but never first.
  const double highest = std::min(reach, box.center.z);
  for (const double x : {-half.x, half.x}) {
    for (const double y : {-half.y, half.y}) {
      for (const double z : {-half.z, half.z}) {
        point_on_floor(body, box.center + x * a + y * b + z * c, highest);
      }
    }
  }
}

void OdeContacts::prism_on_floor(dBodyID body, const OrientedBox& box, Corners outline) {
  const auto& [a, b, c] = box.axes;
  // As for a box, but the middle of its area may be nearer to one side.
  const double highest = std::min(floor_reach(body, box.half), box.center.z);
  for (const Vector2& corner : outline) {
    for (const double z : {-box.half.z, box.half.z}) {
      point_on_floor(body, box.center + corner.x * a + corner.y * b + z * c, highest);
    }
  }
}

void OdeContacts::point_on_floor(dBodyID body, const Vector3& point, double highest) {
  if (point.z > highest) return;
  dContact contact = on_floor(point, friction_);
  attach(body, nullptr, contact, point.z);
}

void OdeContacts::solid_on_floor(dBodyID body, const Shape& shape, const OrientedBox& box) {
  if (shape.kind == Shape::Kind::box) return box_on_floor(body, box);
  if (shape.kind == Shape::Kind::prism) return prism_on_floor(body, box, shape.outline);
  const double highest = std::min(floor_reach(body, box.half), box.center.z);
  if (shape.kind == Shape::Kind::cylinder) return rims_on_floor(body, shape, box, highest);
  const double radius = shape.radius();
  const double core = std::max(0.0, 0.5 * shape.length() - radius);
  const Vector3 along = core * box.axes[static_cast<std::size_t>(shape.axis)];
  const auto ball_on_floor = [&](const Vector3& center) {
    point_on_floor(body, center - Vector3{0.0, 0.0, radius}, highest);
  };
  ball_on_floor(box.center + along);
  if (core > 0.0) ball_on_floor(box.center - along);
}

void OdeContacts::rims_on_floor(dBodyID body, const Shape& shape, const OrientedBox& box,
                                double highest) {
  const auto index = static_cast<std::size_t>(shape.axis);
  const Vector3& axis = box.axes[index];
  // Down the slope of an end; anywhere if there is no slope.
  const Vector3 slope{axis.z * axis.x, axis.z * axis.y, axis.z * axis.z - 1.0};
  const double steepness = std::sqrt(dot(slope, slope));
  const Vector3 down = steepness > kLevel ? (1.0 / steepness) * slope : box.axes[(index + 1) % 3];
  const Vector3 aside = cross(axis, down);
  for (const double end : {-1.0, 1.0}) {
    const Vector3 middle = box.center + 0.5 * end * shape.length() * axis;
    for (const Vector3& spoke : {down, aside, -1.0 * down, -1.0 * aside}) {
      point_on_floor(body, middle + shape.radius() * spoke, highest);
    }
  }
}

void OdeContacts::between(dBodyID a, dBodyID b, const Vector3& point, const Vector3& normal,
                          double gap) {
  dContact contact = contact_at(point, normal, friction_);
  attach(a, b, contact, gap);
}

void OdeContacts::between(dBodyID a, dBodyID b, const dContactGeom& found) {
  dContact contact{};
  contact.surface.mu = friction_;
  contact.geom = found;
  attach(a, b, contact, -found.depth);
}

}  // namespace elsie::physics

#include "part_bodies.h"

#include <numbers>

namespace elsie::physics {
namespace {

/// An upright prism about its middle.
OdeGeom make_prism(Corners outline, double half_height, ConvexArrays& arrays) {
  const auto n = static_cast<unsigned>(outline.size());
  // Point 2 i is at the bottom of corner i, and 2 i + 1 at its top.
  for (const Vector2& corner : outline) {
    for (const double z : {-half_height, half_height}) {
      arrays.points.insert(arrays.points.end(), {corner.x, corner.y, z});
    }
  }
  const auto add_plane = [&](double x, double y, double z, double distance) {
    arrays.planes.insert(arrays.planes.end(), {x, y, z, distance});
  };
  for (unsigned i = 0; i < n; ++i) {
    const unsigned next = (i + 1) % n;
    const Side side = side_of(outline, i);
    add_plane(side.normal.x, side.normal.y, 0.0, -side.gap_to({}));
    arrays.faces.insert(arrays.faces.end(), {4, 2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
  }
  add_plane(0.0, 0.0, 1.0, half_height);
  arrays.faces.push_back(n);
  for (unsigned i = 0; i < n; ++i) arrays.faces.push_back(2 * i + 1);
  add_plane(0.0, 0.0, -1.0, half_height);
  arrays.faces.push_back(n);
  for (unsigned i = n; i-- > 0;) arrays.faces.push_back(2 * i);
  return OdeGeom(dCreateConvex(nullptr, arrays.planes.data(), n + 2, arrays.points.data(), 2 * n,
                               arrays.faces.data()));
}

}  // namespace

dBodyID make_body(dWorldID world, dGeomID geom, const dMass& mass) {
  const dBodyID made = dBodyCreate(world);
  dBodySetMass(made, &mass);
  dBodySetFiniteRotationMode(made, 1);
  dGeomSetBody(geom, made);
  return made;
}

// ODE's cylinders and capsules lie along their z axis; a capsule's length is without its caps.
OdeGeom make_geom(const Shape& shape, ConvexArrays& arrays) {
  const Vector3& size = shape.size;
  const double radius = shape.radius(), length = shape.length();
  switch (shape.kind) {
    case Shape::Kind::box:
      return OdeGeom(dCreateBox(nullptr, size.x, size.y, size.z));
    case Shape::Kind::sphere:
      return OdeGeom(dCreateSphere(nullptr, radius));
    case Shape::Kind::cylinder:
      return OdeGeom(dCreateCylinder(nullptr, radius, length));
    case Shape::Kind::capsule:
      return OdeGeom(dCreateCapsule(nullptr, radius, length - 2.0 * radius));
    default:
      return make_prism(shape.outline, 0.5 * size.z, arrays);
  }
}

void lay(dGeomID geom, const Shape& shape) {
  if (shape.axis == Shape::Axis::up) return;
  const bool is_ahead = shape.axis == Shape::Axis::forward;
  constexpr double kHalf = 0.5 * std::numbers::sqrt2;
  const dQuaternion turned{kHalf, is_ahead ? 0.0 : kHalf, is_ahead ? kHalf : 0.0, 0.0};
  dGeomSetOffsetQuaternion(geom, turned);
}

dMass mass_of(const Shape& shape, double mass) {
  const double radius = shape.radius(), length = shape.length();
  const int direction = static_cast<int>(shape.axis) + 1;
  dMass made;
  switch (shape.kind) {
    case Shape::Kind::box:
      dMassSetBoxTotal(&made, mass, shape.size.x, shape.size.y, shape.size.z);
      break;
    case Shape::Kind::sphere:
      dMassSetSphereTotal(&made, mass, radius);
      break;
    case Shape::Kind::cylinder:
      dMassSetCylinderTotal(&made, mass, direction, radius, length);
      break;
    case Shape::Kind::capsule:
      dMassSetCapsuleTotal(&made, mass, direction, radius, length - 2.0 * radius);
      break;
    default: {
      const Vector3 moments = inertia_of(shape, mass);
      dMassSetParameters(&made, mass, 0.0, 0.0, 0.0, moments.x, moments.y, moments.z,
                         -mass * moments_of(shape.outline).xy, 0.0, 0.0);
    }
  }
  return made;
}

void set_rotation(dBodyID body, const Frame& frame) {
  const Vector3 &f = frame.forward, &l = frame.left, &u = frame.up;
  const dMatrix3 rotation{f.x, l.x, u.x, 0.0, f.y, l.y, u.y, 0.0, f.z, l.z, u.z, 0.0};
  dBodySetRotation(body, rotation);
}

void stop(dBodyID body) {
  dBodySetLinearVel(body, 0.0, 0.0, 0.0);
  dBodySetAngularVel(body, 0.0, 0.0, 0.0);
}

SolidKind kind_of(const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::box:
      return SolidKind::box;
    case Shape::Kind::sphere:
      return SolidKind::ball;
    case Shape::Kind::cylinder:
      return shape.axis == Shape::Axis::up ? SolidKind::pillar : SolidKind::wheel;
    case Shape::Kind::capsule:
      return SolidKind::capsule;
    default:
      return SolidKind::prism;
  }
}

}  // namespace elsie::physics

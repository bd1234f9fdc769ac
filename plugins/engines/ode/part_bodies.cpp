#include "part_bodies.h"

#include <numbers>

namespace elsie::physics {

dBodyID make_body(dWorldID world, dGeomID geom, const dMass& mass) {
  const dBodyID made = dBodyCreate(world);
  dBodySetMass(made, &mass);
  dBodySetFiniteRotationMode(made, 1);
  dGeomSetBody(geom, made);
  return made;
}

// ODE's cylinders and capsules lie along their z axis; a capsule's length is without its caps.
OdeGeom make_geom(const Shape& shape) {
  const Vector3& size = shape.size;
  const double radius = shape.radius(), length = shape.length();
  switch (shape.kind) {
    case Shape::Kind::box:
      return OdeGeom(dCreateBox(nullptr, size.x, size.y, size.z));
    case Shape::Kind::sphere:
      return OdeGeom(dCreateSphere(nullptr, radius));
    case Shape::Kind::cylinder:
      return OdeGeom(dCreateCylinder(nullptr, radius, length));
    default:
      return OdeGeom(dCreateCapsule(nullptr, radius, length - 2.0 * radius));
  }
}

void lay(dGeomID geom, const Shape& shape) {
  if (shape.kind == Shape::Kind::box || shape.axis == Shape::Axis::up) return;
  const bool is_ahead = shape.axis == Shape::Axis::forward;
  constexpr double kHalf = 0.5 * std::numbers::sqrt2;
  const dQuaternion turned{kHalf, is_ahead ? 0.0 : kHalf, is_ahead ? kHalf : 0.0, 0.0};
  dGeomSetOffsetQuaternion(geom, turned);
}

dMass mass_of(const Part& part) {
  const Shape& shape = part.shape;
  const double radius = shape.radius(), length = shape.length();
  const int direction = static_cast<int>(shape.axis) + 1;
  dMass mass;
  switch (shape.kind) {
    case Shape::Kind::box:
      dMassSetBoxTotal(&mass, part.mass, shape.size.x, shape.size.y, shape.size.z);
      break;
    case Shape::Kind::sphere:
      dMassSetSphereTotal(&mass, part.mass, radius);
      break;
    case Shape::Kind::cylinder:
      dMassSetCylinderTotal(&mass, part.mass, direction, radius, length);
      break;
    default:
      dMassSetCapsuleTotal(&mass, part.mass, direction, radius, length - 2.0 * radius);
  }
  return mass;
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
    default:
      return SolidKind::capsule;
  }
}

}  // namespace elsie::physics

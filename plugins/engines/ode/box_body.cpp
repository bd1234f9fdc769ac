#include "box_body.h"

#include <cmath>
#include <cstdint>

#include "body_states.h"

namespace elsie::physics {

BoxBody::BoxBody(dWorldID world, world::ObstacleKind kind_of_box, const world::Fixture& fixture,
                 double mass)
    : kind(kind_of_box),
      solid_shape(fixture.shape),
      form(kind_of(solid_shape)),
      shape{fixture.frame.origin,
            {fixture.frame.forward, fixture.frame.left, fixture.frame.up},
            0.5 * fixture.shape.size},
      made_z(shape.center.z) {
  geom = make_geom(solid_shape, convex_);
  if (is_mobile()) {
    body = dBodyCreate(world);
    dGeomSetBody(geom.get(), body);
  }
  if (kind == world::ObstacleKind::dynamic) {
    const dMass own = mass_of(solid_shape, mass);
    dBodySetMass(body, &own);
    dBodySetFiniteRotationMode(body, 1);
  } else if (body) {
    dBodySetKinematic(body);
  }
  take_shape();
}

/// Moves ODE's body, or its geometry, to where the shape is.
void BoxBody::take_shape() {
  const Vector3& at = shape.center;
  const double heading = std::atan2(shape.axes[0].y, shape.axes[0].x);
  const dQuaternion facing{std::cos(0.5 * heading), 0.0, 0.0, std::sin(0.5 * heading)};
  if (body) {
    dBodySetPosition(body, at.x, at.y, at.z);
    dBodySetQuaternion(body, facing);
  } else {
    dGeomSetPosition(geom.get(), at.x, at.y, at.z);
    dGeomSetQuaternion(geom.get(), facing);
  }
}

void BoxBody::put(const Pose& pose) {
  const Frame frame = Frame::turned({pose.x, pose.y, made_z}, pose.heading_rad, 0.0);
  shape.center = frame.origin;
  shape.axes = {frame.forward, frame.left, frame.up};
  driven = false;
  take_shape();
  if (body) stop(body);
}

/// What is carried glides over the floor: its weight does not press on the robots.
void BoxBody::take_footing() {
  dBodySetGravityMode(body, is_carried() ? 0 : 1);
  if (gives_way()) {
    dBodySetDynamic(body);
  } else {
    stop(body);
    dBodySetKinematic(body);
  }
}

void BoxBody::meet_floor(OdeContacts& contacts) const {
  contacts.solid_on_floor(body, solid_shape, shape);
}

void BoxBody::read_shape() {
  const dReal* r = dBodyGetRotation(body);
  shape.center = to_vector(dBodyGetPosition(body));
  shape.axes = {{{r[0], r[4], r[8]}, {r[1], r[5], r[9]}, {r[2], r[6], r[10]}}};
}

double BoxBody::most_speed() const {
  const Vector3 v = to_vector(dBodyGetLinearVel(body));
  const Vector3 w = to_vector(dBodyGetAngularVel(body));
  const Vector3& half = shape.half;
  return std::sqrt(dot(v, v)) + (half.x + half.y + half.z) * std::sqrt(dot(w, w));
}

void BoxBody::add_to(base::Fnv1a& hash) const {
  hash.add(std::uint64_t{present});
  if (!present) return;
  if (body) return add_body(hash, body);
  add_numbers(hash, dGeomGetPosition(geom.get()), 3);
  dQuaternion facing;
  dGeomGetQuaternion(geom.get(), facing);
  add_numbers(hash, facing, 4);
}

}  // namespace elsie::physics

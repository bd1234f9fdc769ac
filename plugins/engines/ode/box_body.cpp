#include "box_body.h"

#include <cmath>
#include <cstdint>

#include "body_states.h"

namespace elsie::physics {

BoxBody::BoxBody(dWorldID world, world::BoxKind kind_of_box, const world::Fixture& fixture,
                 double mass)
    : kind(kind_of_box),
      form(!fixture.outline.empty()                      ? SolidKind::prism
           : fixture.shape.kind == Shape::Kind::cylinder ? SolidKind::pillar
                                                         : SolidKind::box),
      shape{fixture.frame.origin,
            {fixture.frame.forward, fixture.frame.left, fixture.frame.up},
            0.5 * fixture.shape.size},
      outline(fixture.outline) {
  make_geom();
  const double heading = std::atan2(shape.axes[0].y, shape.axes[0].x);
  const dQuaternion facing{std::cos(0.5 * heading), 0.0, 0.0, std::sin(0.5 * heading)};
  if (!is_mobile()) {
    dGeomSetPosition(geom.get(), shape.center.x, shape.center.y, shape.center.z);
    dGeomSetQuaternion(geom.get(), facing);
    return;
  }
  body = dBodyCreate(world);
  if (kind == world::BoxKind::dynamic) {
    const dMass own = mass_of(mass);
    dBodySetMass(body, &own);
    dBodySetFiniteRotationMode(body, 1);
  } else {
    dBodySetKinematic(body);
  }
  dGeomSetBody(geom.get(), body);
  dBodySetPosition(body, shape.center.x, shape.center.y, shape.center.z);
  dBodySetQuaternion(body, facing);
}

void BoxBody::make_geom() {
  const Vector3& half = shape.half;
  if (form == SolidKind::prism) {
    geom = make_prism(outline, half.z, convex_);
  } else {
    geom.reset(form == SolidKind::pillar
                   ? dCreateCylinder(nullptr, half.x, 2.0 * half.z)
                   : dCreateBox(nullptr, 2.0 * half.x, 2.0 * half.y, 2.0 * half.z));
  }
}

dMass BoxBody::mass_of(double mass) const {
  const Vector3& half = shape.half;
  if (form == SolidKind::prism) return prism_mass(outline, 2.0 * half.z, mass);
  dMass made;
  if (form == SolidKind::pillar) {
    dMassSetCylinderTotal(&made, mass, 3, half.x, 2.0 * half.z);
  } else {
    dMassSetBoxTotal(&made, mass, 2.0 * half.x, 2.0 * half.y, 2.0 * half.z);
  }
  return made;
}

void BoxBody::meet_floor(OdeContacts& contacts) const {
  if (form == SolidKind::prism) {
    contacts.prism_on_floor(body, shape, outline);
  } else if (form == SolidKind::pillar) {
    contacts.solid_on_floor(body, Shape::pillar(shape.half.x, 2.0 * shape.half.z), shape);
  } else {
    contacts.box_on_floor(body, shape);
  }
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

#include "grip.h"

namespace elsie::physics {

Grip::Grip(dWorldID world, std::size_t its_robot, dBodyID its_chassis, std::size_t its_box,
           dBodyID body_of_box)
    : robot(its_robot),
      box(its_box),
      chassis(its_chassis),
      body(body_of_box),
      joint_(dJointCreateFixed(world, nullptr)) {
  dJointAttach(joint_.get(), chassis, body);
  dJointSetFixed(joint_.get());
  const dReal* const at = dBodyGetPosition(body);
  dVector3 place;
  dBodyGetPosRelPoint(chassis, at[0], at[1], at[2], place);
  place_ = to_vector(place);
  dQMultiply1(turned_, dBodyGetQuaternion(chassis), dBodyGetQuaternion(body));
}

Grip::Error Grip::error() const {
  dVector3 place;
  dBodyGetRelPointPos(chassis, place_.x, place_.y, place_.z, place);
  dQuaternion wanted, off;
  dQMultiply0(wanted, dBodyGetQuaternion(chassis), turned_);
  dQMultiply2(off, wanted, dBodyGetQuaternion(body));
  // Of a small angle: twice the vector part.
  const double side = off[0] < 0.0 ? -2.0 : 2.0;
  return {to_vector(place) - to_vector(dBodyGetPosition(body)),
          {side * off[1], side * off[2], side * off[3]}};
}

}  // namespace elsie::physics

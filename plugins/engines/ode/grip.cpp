#include "grip.h"

#include <algorithm>
#include <utility>

#include "checks.h"
#include "shapes.h"

namespace elsie::physics {

Grip::Grip(dWorldID world, const Bodies& bodies, const std::optional<Vector2>& pin)
    : robot(bodies.robot),
      box(bodies.box),
      chassis(bodies.chassis),
      body(bodies.body),
      turns(pin.has_value()),
      joint_(turns ? dJointCreateHinge(world, nullptr) : dJointCreateFixed(world, nullptr)) {
  if (pin) pin_ = {pin->x, pin->y, 0.0};
  const Vector3 at = place();
  dJointAttach(joint_.get(), chassis, body);
  if (turns) {
    dJointSetHingeAnchor(joint_.get(), at.x, at.y, at.z);
    dJointSetHingeAxis(joint_.get(), 0.0, 0.0, 1.0);
  } else {
    dJointSetFixed(joint_.get());
  }
  dVector3 in_chassis;
  dBodyGetPosRelPoint(chassis, at.x, at.y, at.z, in_chassis);
  place_ = to_vector(in_chassis);
  dQMultiply1(turned_, dBodyGetQuaternion(chassis), dBodyGetQuaternion(body));
}

Vector3 Grip::place() const {
  dVector3 at;
  dBodyGetRelPointPos(body, pin_.x, pin_.y, pin_.z, at);
  return to_vector(at);
}

namespace {

/// Where a grip is, or would be.
auto place_in(auto& all, std::size_t robot, std::size_t box) {
  return std::lower_bound(
      all.begin(), all.end(), std::pair(box, robot),
      [](const Grip& grip, const auto& key) { return std::pair(grip.box, grip.robot) < key; });
}

}  // namespace

void Grips::add(Grip grip) {
  require(!has(grip.robot, grip.box), "The robot holds the box already.");
  const auto place = place_in(all_, grip.robot, grip.box);
  all_.insert(place, std::move(grip));
}

bool Grips::remove(std::size_t robot, std::size_t box) {
  if (!has(robot, box)) return false;
  all_.erase(place_in(all_, robot, box));
  return true;
}

bool Grips::has(std::size_t robot, std::size_t box) const {
  const auto place = place_in(all_, robot, box);
  return place != all_.end() && place->box == box && place->robot == robot;
}

Grip::Error Grip::error() const {
  dVector3 wanted_place;
  dBodyGetRelPointPos(chassis, place_.x, place_.y, place_.z, wanted_place);
  const Vector3 way = to_vector(wanted_place) - place();
  if (turns) {
    const dReal *own = dBodyGetRotation(body), *carrier = dBodyGetRotation(chassis);
    return {way, cross({own[2], own[6], own[10]}, {carrier[2], carrier[6], carrier[10]})};
  }
  dQuaternion wanted, off;
  dQMultiply0(wanted, dBodyGetQuaternion(chassis), turned_);
  dQMultiply2(off, wanted, dBodyGetQuaternion(body));
  // Of a small angle: twice the vector part.
  const double side = off[0] < 0.0 ? -2.0 : 2.0;
  return {way, {side * off[1], side * off[2], side * off[3]}};
}

}  // namespace elsie::physics

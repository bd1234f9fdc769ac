// A robot that holds a box.
#pragma once

#include <cstddef>

#include "elsie/api/geometry.h"

#include "ode_handles.h"

namespace elsie::physics {

/// The joint between a chassis and the box that it holds: the box stays where it was in the frame
/// of the chassis. One that `turns` only keeps its place, and stays upright.
struct Grip {
  Grip(dWorldID world, std::size_t its_robot, dBodyID its_chassis, std::size_t its_box,
       dBodyID body_of_box, bool it_turns);

  /// How the box has to move in the world to be where it was held: m, from its place, and rad.
  struct Error {
    Vector3 way, turn;
  };
  Error error() const;

  std::size_t robot = 0, box = 0;
  dBodyID chassis = nullptr, body = nullptr;
  bool turns = false;

 private:
  OdeJoint joint_;
  Vector3 place_;       // of the box, in the frame of the chassis
  dQuaternion turned_;  // likewise
};

}  // namespace elsie::physics

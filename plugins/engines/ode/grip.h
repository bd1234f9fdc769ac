// A robot that holds a box.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

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

/// Those of an engine, ascending by box and robot.
class Grips {
 public:
  /// Throws std::invalid_argument if the robot holds the box already.
  void add(Grip grip);
  /// Returns whether the robot held the box.
  bool remove(std::size_t robot, std::size_t box);
  void remove_box(std::size_t box) {
    std::erase_if(all_, [&](const Grip& grip) { return grip.box == box; });
  }
  bool has(std::size_t robot, std::size_t box) const;
  std::span<const Grip> all() const { return all_; }

 private:
  std::vector<Grip> all_;
};

}  // namespace elsie::physics

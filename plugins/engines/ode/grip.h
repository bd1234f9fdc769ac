// A robot that holds a box.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "elsie/api/geometry.h"

#include "ode_handles.h"

namespace elsie::physics {

/// The joint between a chassis and the box that it holds: the box stays where it was in the frame
/// of the chassis. One that `turns` is pinned at a point, and stays upright.
struct Grip {
  /// Who holds what.
  struct Bodies {
    std::size_t robot = 0, box = 0;
    dBodyID chassis = nullptr, body = nullptr;  // of the box
  };
  /// `pin`: in the frame of the box, m, where it turns; none: it does not.
  Grip(dWorldID world, const Bodies& bodies, const std::optional<Vector2>& pin);

  /// Where the box is held, in the world.
  Vector3 place() const;
  /// How the box has to move in the world to be where it was held: m, at that place, and rad.
  struct Error {
    Vector3 way, turn;
  };
  Error error() const;

  std::size_t robot = 0, box = 0;
  dBodyID chassis = nullptr, body = nullptr;
  bool turns = false;

 private:
  OdeJoint joint_;
  Vector3 pin_;         // where it is held, in the frame of the box
  Vector3 place_;       // the same, in the frame of the chassis
  dQuaternion turned_;  // the box, in that frame
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

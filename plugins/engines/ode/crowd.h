// Bodies whose contacts are too many for ODE's solver.
#pragma once

#include <unordered_map>
#include <vector>

#include "elsie/world/description.h"

#include "impulse_solver.h"
#include "ode_contacts.h"
#include "ode_robot.h"

namespace elsie::physics {

/// Moves robots and boxes that touch each other in great numbers by a step.
///
/// ODE's dWorldStep solves a dense system over everything that touches, whose cost grows with the
/// cube of their number: a second of thirty robots that drive to one point takes it 1.8 s, of a
/// hundred half a minute. Here it grows with their number. A robot's wheels and casters cannot move
/// against its chassis but by turning, so a robot is one rigid body and its spinning wheels,
/// without any row for their joints; the contacts and motors are rows of an iterative solver.
///
/// Differences from ODE's step: a caster's own turning, and gyroscopic torques, are left out.
class Crowd {
 public:
  explicit Crowd(const world::Physics& physics) : physics_(physics) {}

  void clear();
  void add_robot(const OdeRobot& robot);
  /// A box that can be pushed, or one that moves along a path of its own.
  void add_box(dBodyID box);
  /// Between bodies that were added, or one of them and what stands fast.
  void add_contact(const FoundContact& contact);

  bool empty() const { return places_.empty(); }
  /// Gives the bodies the velocities after the step, and moves them. What hangs on a chassis is
  /// left to OdeVehicle::settle().
  void step();

 private:
  /// Where a body of ODE is in the solver.
  struct Place {
    int body = ImpulseSolver::kNone;
    int spin = ImpulseSolver::kNone;  // of a wheel
    Vector3 center;                   // of a wheel
    Vector3 axle;                     // of a wheel: a unit vector
    bool glides = false;              // a caster: a ball without friction
  };
  /// A body of ODE that is moved.
  struct Moved {
    dBodyID body;
    int index;
    Vector3 middle;  // of the body, from the center of mass of what it is part of
  };
  struct Wheel {
    dBodyID body;
    int carrier;
    int spin;
    Vector3 axle;
  };
  using Row = ImpulseSolver::Row;

  int add_rigid(dBodyID body);
  int add_vehicle(const OdeVehicle& vehicle);
  void add_motor(const OdeVehicle::Motor& motor, int carrier, int spin, const Vector3& axle);
  void add_hitch(const OdeVehicle& vehicle, int front, const Frame& front_frame, int body);
  Row row_along(const FoundContact& contact, const Vector3& direction) const;
  /// How fast the bodies part before the step, m/s.
  double normal_speed(const Row& row) const;

  world::Physics physics_;
  ImpulseSolver solver_;
  std::unordered_map<dBodyID, Place> places_;
  std::vector<Moved> moved_;
  std::vector<Wheel> wheels_;
};

}  // namespace elsie::physics

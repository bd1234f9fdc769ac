// Bodies with too many contacts for ODE's solver.
#pragma once

#include <unordered_map>
#include <vector>

#include "elsie/world/description.h"

#include "grip.h"
#include "impulse_solver.h"
#include "newton_solver.h"
#include "ode_contacts.h"
#include "ode_robot.h"
#include "softness.h"

namespace elsie::physics {

/// Moves robots and boxes by a step when very many of them touch each other, or hang together.
///
/// ODE's dWorldStep solves a dense system over all bodies that touch, and its cost grows with the
/// cube of their number: it takes 1.8 s for a second of thirty robots that drive to one point, half
/// a minute for a hundred, and 6 s for a train of a hundred segments. Here the cost grows with the
/// number. The wheels and casters of a robot only turn against its chassis, so a robot is one rigid
/// composite with spinning wheels, without rows for their joints.
///
/// A step of the length h changes the velocities v by gravity g and by the impulses p of the rows,
///
///   v1 = v0 + h g + M^-1 J' p,   J v1 = target - softness p,   lower <= p <= upper,
///
/// and moves the bodies with v1. The rows J, with erp and cfm as in softness.h:
///
///   contact   along the normal, p >= 0: target = erp depth / h, at most kMaxCorrectingSpeed, or
///   the
///             speed of a bounce; softness = cfm / h
///   friction  along two tangents, |p| <= mu p_normal; softness = slip / h, so that a tyre glides
///   at
///             the slip times its force, p / h
///   motor     a wheel against its chassis: target = the rate that is set, |p| <= h torque
///   grip      six rows hold a box to the chassis, five if it turns: target = erp error / h
///   hitch     three rows hold its point and one prevents roll: target = 0. Its stops are rows with
///             p >= 0 and target = -(way to the limit) / h; a motor instead of the yaw's stop is as
///             the motor of a wheel
///
/// Differences from ODE's step: the turning of casters and gyroscopic torques are left out.
class Crowd {
 public:
  explicit Crowd(const world::Physics& physics)
      : physics_(physics), softness_(softness_of(physics)) {}

  void clear();
  void add_robot(const OdeRobot& robot);
  /// A box that can be pushed, or one that moves along its own path.
  void add_obstacle(dBodyID box);
  /// A robot that was added holds a box that was added.
  void add_grip(const Grip& grip);
  /// A contact between two bodies that were added, or between one of them and a fixed body.
  void add_contact(const FoundContact& contact);

  /// After step(): the impulse on the body `a` of a contact that was added, N s.
  Vector3 impulse(const ContactImpulse& of) const;

  bool empty() const { return places_.empty(); }
  /// Sweeps suit heaps, in which everything touches everything; Newton's method suits chains.
  enum class Method { sweeps, newton };
  /// Gives the bodies the velocities after the step, and moves them. OdeVehicle::settle() then
  /// moves the parts that hang on a chassis.
  void step(Method method);

 private:
  /// The place of an ODE body in the solver.
  struct Place {
    int body = ImpulseSolver::kNone;
    int spin = ImpulseSolver::kNone;  // of a wheel
    Vector3 center;                   // of a wheel
    Vector3 axle;                     // of a wheel: a unit vector
    bool glides = false;              // a caster: a ball without friction
  };
  /// An ODE body that is moved.
  struct Moved {
    dBodyID body;
    int index;
    Vector3 middle;  // of the body, from its vehicle's center of mass
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
  /// The speed at which the bodies part before the step, m/s.
  double normal_speed(const Row& row) const;

  world::Physics physics_;
  Softness softness_;
  ImpulseSolver solver_;
  NewtonSolver newton_;
  std::unordered_map<dBodyID, Place> places_;
  std::vector<Moved> moved_;
  std::vector<Wheel> wheels_;
};

}  // namespace elsie::physics

// The bodies of one robot in ODE.
#pragma once

#include <array>

#include "elsie/physics/engine.h"
#include "elsie/world/description.h"

#include "ode_contacts.h"
#include "ode_handles.h"
#include "scene.h"

namespace elsie::physics {

/// A chassis, two driven wheels on hinges with motors, and two casters on ball joints, one before
/// and one behind the axle, as far out as fits below the chassis.
///
/// The chassis is the master: after every step the wheels and casters are put back to where their
/// joints hold them, with the velocities that go with that, and keep only the turning of the wheels
/// as their own. ODE moves each body along a straight line in a step; a wheel of a robot that turns
/// in place at 11 rad/s would leave its circle by a millimetre in a step of 0.02 s, and the
/// joint's error reduction would only pull it back by a fifth of that.
class OdeRobot {
 public:
  OdeRobot(dWorldID world, const world::RobotBody& body, const Pose& pose, double z);

  void set_wheel_rates(const MotorCommand& rates);
  /// Contacts of all parts with the floor, of which `floor` is the geometry.
  void meet_floor(OdeContacts& contacts, dGeomID floor) const;
  /// After a step of `step` s: joints to their places, and the new state. False if a number in it
  /// is not finite.
  bool settle(double step);

  const RobotState& state() const { return state_; }
  const world::RobotBody& dimensions() const { return dimensions_; }
  /// Where it is, for sensors and neighbours; it may come as far as its speed carries it.
  void place_in(Scene& scene, Scene::Id id, double step) const;

  enum Part { chassis, left_wheel, right_wheel, front_caster, rear_caster, part_count };
  dBodyID body(Part part) const { return bodies_[part]; }
  dGeomID geom(Part part) const { return geoms_[part].get(); }
  const OrientedBox& chassis_box() const { return chassis_box_; }
  const std::array<Cylinder, 2>& wheels() const { return wheels_; }
  double caster_radius() const { return caster_radius_; }
  bool is_upright() const { return state_.frame.up.z > 0.995; }

 private:
  void read_shape();

  world::RobotBody dimensions_;
  double caster_radius_;
  double caster_x_;
  std::array<dBodyID, part_count> bodies_{};
  std::array<OdeGeom, part_count> geoms_;
  std::array<dJointID, 2> hinges_{};
  std::array<double, 2> wheel_angles_{};  // rad, in [-pi, pi]
  RobotState state_;
  Vector3 velocity_;
  Vector3 turning_;
  OrientedBox chassis_box_;
  std::array<Cylinder, 2> wheels_;
};

}  // namespace elsie::physics

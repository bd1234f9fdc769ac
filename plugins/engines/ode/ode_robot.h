// The bodies of one robot in ODE.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "elsie/physics/engine.h"

#include "ode_vehicle.h"
#include "scene.h"

namespace elsie::physics {

/// A vehicle, and the vehicles that it pulls.
class OdeRobot {
 public:
  OdeRobot(dWorldID world, const BodyPlan& plan, const Pose& pose, double z);

  /// A copy of another robot, in the same state.
  OdeRobot(dWorldID world, const OdeRobot& other);

  /// Puts the robot at a pose, at rest, with its vehicles in line behind it.
  void put(const Pose& pose, double z);
  /// Takes the velocity of another robot; the whole robot moves as one rigid body.
  void push(const OdeRobot& other);
  /// See Engine::set_joints(). The motors get them at the start of the next step.
  void set_joints(std::span<const JointSetting> settings);
  /// The measured settings, one for each joint that can be set.
  std::span<const JointSetting> joints() const { return joints_; }
  void begin_step(double step);
  void meet_floor(OdeContacts& contacts, dGeomID floor) const;
  /// After a step of `step` s: puts joints back in place and reads the new state. False if a number
  /// in it is not finite.
  bool settle(double step);

  const RobotState& state() const { return state_; }
  SegmentState segment(std::size_t segment) const;
  const std::vector<OdeVehicle>& vehicles() const { return vehicles_; }
  /// The height of its highest part above the floor on which it stands, m.
  double height() const { return height_; }
  /// The highest speed that any of its parts can reach with these wheel rates, m/s; see bounds.h.
  double most_speed(std::span<const JointSetting> settings) const;
  /// Puts a vehicle into the scene, for sensors and neighbours; see Scene::place_robot().
  bool place_in(Scene& scene, std::size_t vehicle, Scene::Id id, double step) const {
    return vehicles_[vehicle].place_in(scene, id, step);
  }

  /// Calls `call` with every dBodyID, always in the same order.
  template <class Call>
  void for_each_body(Call call) const {
    for (const OdeVehicle& vehicle : vehicles_) vehicle.for_each_body(call);
  }

 private:
  void read_state();

  BodyPlan plan_;
  // The pose at the start: the places of the joints on the bodies follow from it, with rounding.
  Pose made_at_;
  double made_z_;
  std::vector<OdeVehicle> vehicles_;
  std::vector<JointSetting> joints_;
  std::vector<JointSetting> wanted_;  // if they are new; else empty
  RobotState state_;
  double height_ = 0.0;
  double lever_ = 1.0;
  std::vector<double> radii_;  // of the joints that can be set; 0: not a wheel
};

}  // namespace elsie::physics

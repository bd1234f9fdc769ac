// The bodies of one robot in ODE.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "elsie/physics/engine.h"
#include "elsie/world/description.h"

#include "ode_contacts.h"
#include "ode_handles.h"
#include "ode_segment.h"
#include "scene.h"
#include "vehicle.h"

namespace elsie::physics {

/// A chassis, two driven wheels on hinges with motors, and two casters on ball joints, one before
/// and one behind the axle, as far out as fits below the chassis; and the segments that it pulls.
///
/// The chassis is the master: after every step the wheels and casters are put back to where their
/// joints hold them, with the velocities that go with that, and keep only the turning of the wheels
/// as their own. ODE moves each body along a straight line in a step; a wheel of a robot that turns
/// in place at 11 rad/s would leave its circle by a millimetre in a step of 0.02 s, and the
/// joint's error reduction would only pull it back by a fifth of that.
class OdeRobot {
 public:
  OdeRobot(dWorldID world, const world::RobotBody& body, std::span<const world::Segment> segments,
           const Pose& pose, double z);

  /// Stands there at rest, its segments in line behind it.
  void put(const Pose& pose, double z);
  void set_wheel_rates(const MotorCommand& rates);
  /// Before a step of this length: joints that it would bring past their limits are stopped there.
  void stop_at_limits(double step);
  /// Contacts of all parts with the floor, of which `floor` is the geometry.
  void meet_floor(OdeContacts& contacts, dGeomID floor) const;
  /// After a step of `step` s: joints to their places, and the new state. False if a number in it
  /// is not finite.
  bool settle(double step);

  const RobotState& state() const { return state_; }
  const world::RobotBody& dimensions() const { return dimensions_; }
  /// How many times as fast as a wheel's rim a corner of it, or of what it pulls, can move: see
  /// bounds.h.
  double lever() const { return lever_; }
  const std::vector<OdeSegment>& segments() const { return segments_; }
  /// Its bodies and motors.
  struct Parts {
    dBodyID chassis;
    std::array<dBodyID, 2> wheels;   // left, right
    std::array<dBodyID, 2> casters;  // front, rear
    std::array<dJointID, 2> motors;  // hinges, left and right
  };
  Parts parts() const;
  /// The robot itself is vehicle 0, its segments follow.
  std::size_t vehicle_count() const { return 1 + segments_.size(); }
  Vehicle vehicle(std::size_t index) const;
  /// Where a vehicle is, for sensors and neighbours.
  void place_in(Scene& scene, std::size_t vehicle, Scene::Id id, double step) const;

  /// Calls it with every dBodyID, always in the same order.
  template <class Call>
  void for_each_body(Call call) const {
    for (const dBodyID body : bodies_) call(body);
    for (const OdeSegment& segment : segments_) call(segment.body());
  }
  /// Calls it with the chassis, which is no segment, and with each segment's number and body.
  template <class Call>
  void for_each_middle(Call call) const {
    call(std::optional<std::size_t>(), bodies_[chassis]);
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      call(std::optional<std::size_t>(i), segments_[i].body());
    }
  }

 private:
  enum Part { chassis, left_wheel, right_wheel, front_caster, rear_caster, part_count };

  void link_wheels(dWorldID world, const Frame& frame);
  void link_casters(dWorldID world, const Frame& frame);
  bool settle_chassis(double step);

  world::RobotBody dimensions_;
  double caster_radius_;
  double caster_x_;
  double lever_;
  std::array<dBodyID, part_count> bodies_{};
  std::array<OdeGeom, part_count> geoms_;
  std::array<dJointID, 2> hinges_{};
  std::array<double, 2> wheel_angles_{};  // rad, in [-pi, pi]
  RobotState state_;
  Vector3 velocity_;
  Vector3 turning_;
  OrientedBox chassis_box_;
  std::array<Cylinder, 2> wheels_;
  std::vector<world::Coupling> couplings_;
  std::vector<OdeSegment> segments_;
};

}  // namespace elsie::physics

// The bodies of one vehicle in ODE.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "elsie/api/body.h"
#include "elsie/physics/engine.h"

#include "composite.h"
#include "ode_contacts.h"
#include "ode_handles.h"
#include "part_bodies.h"
#include "scene.h"
#include "solids.h"

namespace elsie::physics {

/// A chassis, wheels with motors (bodies on hinges), wheels without, and casters on ball joints. A
/// wheel without a motor has no mass or spin of its own: it is a contact that has grip sideways and
/// rolls freely. A vehicle that is pulled has a universal joint at its front.
///
/// The chassis is the master: after every step the wheels and casters are put back to where their
/// joints hold them, with the matching velocities. Only the spin of the wheels is their own. ODE
/// moves each body along a straight line in a step; a wheel of a robot that turns in place at 11
/// rad/s would leave its circle by a millimetre in a step of 0.02 s, and the joint's error
/// reduction would correct only a fifth of that. Steered wheels turn at the rate of their steering,
/// whatever they touch: the steering motor is as strong as necessary.
///
/// The master of a pulled vehicle is the one in front: the pulled one is put back to where its
/// joint holds it, and turned no further than the joint's limits. Unlike a wheel it keeps its
/// velocity: it may be heavier than the robot, and a velocity computed from the robot's would add
/// momentum. ODE brings the velocities together in the next step. Three points of support are never
/// redundant, the solver has a dozen rows fewer per segment than with wheels on hinges, and no
/// wheel can drift off.
class OdeVehicle {
 public:
  /// `parts` are those of one vehicle, the chassis first.
  OdeVehicle(dWorldID world, std::span<const Part> parts);

  /// Puts the vehicle there, upright and at rest, its steering straight ahead.
  void put(const Frame& frame, double heading_rad);
  /// Links wheels and casters to the chassis, and the chassis to the vehicle in front, if there is
  /// one. All must be in place; `frame` is where the vehicle was put.
  void link(dWorldID world, dBodyID front, const Frame& frame);

  /// Takes the state of another vehicle that was made of the same parts.
  void take(const OdeVehicle& other);
  /// Takes the velocity of a body that turns about `middle`.
  void push(const Vector3& velocity, const Vector3& turning, const Vector3& middle);
  /// Sets the joints of the plan that can be set (Engine::set_joints()), in order; returns the
  /// settings of the vehicles behind.
  std::span<const JointSetting> set(std::span<const JointSetting> settings);
  /// Before a step of this length: turns the steering, and stops a hitch at its limit if the step
  /// would bring it past that. ODE notices the limit of a joint only in the step after it was
  /// passed, which at 10 rad/s may be 10 degrees later.
  void begin_step(double step);
  /// Makes the contacts of all parts with the floor, whose geometry is `floor`.
  void meet_floor(OdeContacts& contacts, dGeomID floor) const;
  /// After a step of `step` s: puts joints back in place and reads the new state. `front` is the
  /// frame of the vehicle in front. False if a number is not finite.
  bool settle(double step, const Frame* front);
  /// Puts it into the scene, for sensors and neighbours; see Scene::place_robot().
  bool place_in(Scene& scene, Scene::Id id, double step) const;

  /// A wheel with a motor.
  struct Motor {
    dBodyID body;
    dJointID hinge;
  };
  struct Wheel {
    Part part;
    WheelJoint joint;
    std::optional<Motor> motor;
    OdeGeom geom;
    double about_axle = 0.0;  // kg m2, with a motor
    double rest_rad = 0.0;    // direction when it is not steered, in the vehicle's frame
    JointSetting wanted;
    JointSetting now;     // rates and angles, measured
    double turned = 0.0;  // rad, about its axle, in [-pi, pi]
  };

  const Frame& frame() const { return frame_; }
  const Vector3& velocity() const { return velocity_; }
  const Vector3& turning() const { return turning_; }
  double yaw_rad() const { return hitch_state_.yaw_rad; }
  double pitch_rad() const { return hitch_state_.pitch_rad; }
  dBodyID chassis() const { return chassis_; }
  const std::vector<Wheel>& wheels() const { return wheels_; }
  const std::vector<Cylinder>& wheel_shapes() const { return wheel_shapes_; }
  std::span<const dBodyID> casters() const { return casters_; }
  const std::optional<HitchJoint>& hitch() const { return hitch_; }
  /// The place of its hitch joint.
  Vector3 hitch_place() const { return frame_.point({hitch_->ahead, 0.0, hitch_->height}); }
  /// The rate at which the motor turns the hitch in this step, rad/s.
  double hitch_rate() const { return hitch_state_.rate; }
  /// All parts that move as one with the chassis.
  const Composite& composite() const { return composite_; }
  const Vehicle& solids() const { return solids_; }

  /// Calls `call` with every dBodyID, always in the same order.
  template <class Call>
  void for_each_body(Call call) const {
    call(chassis_);
    for (const Wheel& wheel : wheels_) {
      if (wheel.motor) call(wheel.motor->body);
    }
    for (const dBodyID caster : casters_) call(caster);
  }

 private:
  struct HitchState {
    double yaw_rad = 0.0, pitch_rad = 0.0;
    double wanted_yaw_rad = 0.0;
    double rate = 0.0;  // rad/s, of its motor in this step
    bool stopping = false;
    dJointID joint = nullptr;
  };

  bool wheels_are_inside() const;
  void add_wheel(dWorldID world, const Part& part, const WheelJoint& joint);
  void add_caster(dWorldID world, const Part& part);
  void link_wheels(dWorldID world, const Frame& frame);
  static double heading_of(const Wheel& wheel);
  void turn_geom(const Wheel& wheel) const;
  void link_hitch(dWorldID world, dBodyID front);
  void steer(Wheel& wheel, double step);
  void turn_wheel(const Wheel& wheel, const dQuaternion chassis) const;
  void begin_hitch(double step);
  bool settle_at_hitch(const Frame& front);
  void limit_hitch(const Frame& front);
  void carry(dBodyID body, const Vector3& at) const;
  void read_frame();
  void read_shapes();

  Composite composite_;
  Shape shape_;     // of the chassis
  Vector3 middle_;  // of the chassis, in the vehicle's frame
  dBodyID chassis_ = nullptr;
  ConvexArrays convex_;  // of the geometry, if it is a prism
  OdeGeom chassis_geom_;
  std::vector<Wheel> wheels_;
  std::vector<Vector3> caster_places_;
  std::vector<dBodyID> casters_;
  std::vector<OdeGeom> caster_geoms_;
  std::vector<double> caster_radii_;
  std::optional<HitchJoint> hitch_;
  HitchState hitch_state_;
  Frame frame_;
  Vector3 velocity_;
  Vector3 turning_;
  Vehicle solids_;
  std::vector<Cylinder> wheel_shapes_;
};

}  // namespace elsie::physics

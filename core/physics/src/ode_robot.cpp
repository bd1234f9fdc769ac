#include "ode_robot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace elsie::physics {
namespace {

// Sensors at the top of the chassis look level over it. So that robots of one size see each other,
// range sensors see a chassis that is higher by what a sensor on it would stand out.
constexpr double kSensorDeck = 0.02;  // m

// How much further it may come in a step than at its present speed, by being accelerated.
constexpr double kSlack = 1e-3;  // m

// A caster is light against the chassis, so that it does not matter how it spins.
constexpr double kCasterMass = 0.02;  // of the chassis' mass

// ODE's solver gives up where two motors of equal strength reach their limits at the same instant.
constexpr double kTieBreaker = 1e-6;

constexpr double kHalfSqrt2 = 0.5 * std::numbers::sqrt2;

bool is_finite(const Vector3& v) { return std::isfinite(v.x + v.y + v.z); }

/// The orientation of a wheel that is turned by `angle` about the robot's y axis, in the robot's
/// frame. ODE's cylinders lie along their z axis.
void wheel_rotation(double angle, dQuaternion q) {
  const double c = std::cos(0.5 * angle) * kHalfSqrt2, s = std::sin(0.5 * angle) * kHalfSqrt2;
  q[0] = c;
  q[1] = -c;
  q[2] = s;
  q[3] = s;
}

}  // namespace

OdeRobot::OdeRobot(dWorldID world, const world::RobotBody& body, const Pose& pose, double z)
    : dimensions_(body),
      caster_radius_(std::min({0.5 * body.clearance, 0.125 * body.length, body.wheel_radius})),
      caster_x_(0.5 * body.length - 1.2 * caster_radius_) {
  const double c = std::cos(pose.heading_rad), s = std::sin(pose.heading_rad);
  const Frame frame{{pose.x, pose.y, z}, {c, s, 0.0}, {-s, c, 0.0}, {0.0, 0.0, 1.0}};
  const dQuaternion facing{std::cos(0.5 * pose.heading_rad), 0.0, 0.0,
                           std::sin(0.5 * pose.heading_rad)};

  const auto make = [&](Part part, dGeomID geom, const dMass& mass, const Vector3& place,
                        const dQuaternion rotation) {
    const dBodyID made = dBodyCreate(world);
    const Vector3 at = frame.point(place);
    dBodySetMass(made, &mass);
    dBodySetPosition(made, at.x, at.y, at.z);
    dBodySetQuaternion(made, rotation);
    dBodySetFiniteRotationMode(made, 1);
    dGeomSetBody(geom, made);
    bodies_[part] = made;
    geoms_[part].reset(geom);
  };

  dMass mass;
  dMassSetBoxTotal(&mass, body.mass, body.length, body.width, body.height);
  make(chassis, dCreateBox(nullptr, body.length, body.width, body.height), mass,
       {0.0, 0.0, body.clearance + 0.5 * body.height}, facing);

  dQuaternion upright_wheel, wheel_facing;
  wheel_rotation(0.0, upright_wheel);
  dQMultiply0(wheel_facing, facing, upright_wheel);
  dMassSetCylinderTotal(&mass, body.wheel_mass, 3, body.wheel_radius, body.wheel_width);
  for (const Part part : {left_wheel, right_wheel}) {
    const double y = part == left_wheel ? body.half_axle() : -body.half_axle();
    make(part, dCreateCylinder(nullptr, body.wheel_radius, body.wheel_width), mass,
         {0.0, y, body.wheel_radius}, wheel_facing);
    const dJointID hinge = dJointCreateHinge(world, nullptr);
    dJointAttach(hinge, bodies_[part], bodies_[chassis]);
    const Vector3 at = frame.point({0.0, y, body.wheel_radius});
    dJointSetHingeAnchor(hinge, at.x, at.y, at.z);
    dJointSetHingeAxis(hinge, frame.left.x, frame.left.y, frame.left.z);
    const double torque = body.wheel_torque * (part == left_wheel ? 1.0 : 1.0 + kTieBreaker);
    dJointSetHingeParam(hinge, dParamFMax, torque);
    dJointSetHingeParam(hinge, dParamVel, 0.0);
    hinges_[part == left_wheel ? 0 : 1] = hinge;
  }

  dMassSetSphereTotal(&mass, kCasterMass * body.mass, caster_radius_);
  for (const Part part : {front_caster, rear_caster}) {
    const Vector3 place{part == front_caster ? caster_x_ : -caster_x_, 0.0, caster_radius_};
    make(part, dCreateSphere(nullptr, caster_radius_), mass, place, facing);
    const dJointID ball = dJointCreateBall(world, nullptr);
    dJointAttach(ball, bodies_[part], bodies_[chassis]);
    const Vector3 at = frame.point(place);
    dJointSetBallAnchor(ball, at.x, at.y, at.z);
  }
  read_shape();
}

void OdeRobot::set_wheel_rates(const MotorCommand& rates) {
  dJointSetHingeParam(hinges_[0], dParamVel, rates.left);
  dJointSetHingeParam(hinges_[1], dParamVel, rates.right);
}

void OdeRobot::meet_floor(OdeContacts& contacts, dGeomID floor) const {
  // The rolling radius and the track are exact when a wheel touches the floor in one point, the
  // lowest of its middle disc.
  for (std::size_t i = 0; i < 2; ++i) {
    const Cylinder& wheel = wheels_[i];
    const Part part = i == 0 ? left_wheel : right_wheel;
    const Vector3& axis = wheel.axis;
    const double level = std::sqrt(axis.x * axis.x + axis.y * axis.y);
    const double sinking = -dBodyGetLinearVel(bodies_[part])[2];
    if (level > 0.99) {
      const Vector3 down =
          (1.0 / level) * Vector3{axis.x * axis.z, axis.y * axis.z, -level * level};
      const Vector3 lowest = wheel.center + wheel.radius * down;
      if (lowest.z <= contacts.margin(sinking)) {
        contacts.wheel_on_floor(bodies_[part], lowest, {axis.y / level, -axis.x / level, 0.0});
      }
    } else {
      std::array<dContactGeom, 4> found;
      const int count = dCollide(geoms_[part].get(), floor, static_cast<int>(found.size()),
                                 found.data(), sizeof(dContactGeom));
      for (int k = 0; k < count; ++k) {
        contacts.between(bodies_[part], nullptr, found[static_cast<std::size_t>(k)]);
      }
    }
  }
  for (const Part part : {front_caster, rear_caster}) {
    Vector3 lowest = to_vector(dBodyGetPosition(bodies_[part]));
    lowest.z -= caster_radius_;
    if (lowest.z <= contacts.margin(-dBodyGetLinearVel(bodies_[part])[2])) {
      contacts.caster_on_floor(bodies_[part], lowest);
    }
  }
  contacts.box_on_floor(bodies_[chassis], chassis_box_);
}

bool OdeRobot::settle(double step) {
  const dBodyID master = bodies_[chassis];
  velocity_ = to_vector(dBodyGetLinearVel(master));
  turning_ = to_vector(dBodyGetAngularVel(master));
  const Vector3 old_axis = wheels_[0].axis;
  std::array<double, 2> rates;
  for (std::size_t i = 0; i < 2; ++i) {
    const Vector3 spin = to_vector(dBodyGetAngularVel(bodies_[left_wheel + i]));
    rates[i] = dot(old_axis, spin - turning_);
    wheel_angles_[i] = std::remainder(wheel_angles_[i] + step * rates[i], 2.0 * std::numbers::pi);
  }
  read_shape();
  state_.wheel_rates = {rates[0], rates[1]};
  state_.speed = dot(velocity_, state_.frame.forward);
  state_.turn_rate = turning_.z;
  if (!is_finite(state_.frame.origin) || !is_finite(velocity_) || !is_finite(turning_) ||
      !is_finite(state_.frame.forward) || !std::isfinite(rates[0] + rates[1])) {
    return false;
  }

  const auto carry = [&](Part part, const Vector3& at) {
    const Vector3 v = velocity_ + cross(turning_, at - chassis_box_.center);
    dBodySetPosition(bodies_[part], at.x, at.y, at.z);
    dBodySetLinearVel(bodies_[part], v.x, v.y, v.z);
  };
  for (std::size_t i = 0; i < 2; ++i) {
    const Part part = i == 0 ? left_wheel : right_wheel;
    carry(part, wheels_[i].center);
    dQuaternion turned, q;
    wheel_rotation(wheel_angles_[i], turned);
    dQMultiply0(q, dBodyGetQuaternion(master), turned);
    dBodySetQuaternion(bodies_[part], q);
    const Vector3 w = turning_ + rates[i] * wheels_[i].axis;
    dBodySetAngularVel(bodies_[part], w.x, w.y, w.z);
  }
  carry(front_caster, state_.frame.point({caster_x_, 0.0, caster_radius_}));
  carry(rear_caster, state_.frame.point({-caster_x_, 0.0, caster_radius_}));
  return true;
}

void OdeRobot::read_shape() {
  const world::RobotBody& d = dimensions_;
  const dReal* r = dBodyGetRotation(bodies_[chassis]);
  const Vector3 center = to_vector(dBodyGetPosition(bodies_[chassis]));
  Frame& frame = state_.frame;
  frame.forward = {r[0], r[4], r[8]};
  frame.left = {r[1], r[5], r[9]};
  frame.up = {r[2], r[6], r[10]};
  frame.origin = center - (d.clearance + 0.5 * d.height) * frame.up;
  state_.pose = {frame.origin.x, frame.origin.y, std::atan2(frame.forward.y, frame.forward.x)};
  chassis_box_ = {center,
                  {frame.forward, frame.left, frame.up},
                  {0.5 * d.length, 0.5 * d.width, 0.5 * d.height}};
  for (std::size_t i = 0; i < 2; ++i) {
    wheels_[i] = {frame.point({0.0, (i == 0 ? 1.0 : -1.0) * d.half_axle(), d.wheel_radius}),
                  frame.left, d.wheel_radius, 0.5 * d.wheel_width};
  }
}

void OdeRobot::place_in(Scene& scene, Scene::Id id, double step) const {
  const world::RobotBody& d = dimensions_;
  const Frame& frame = state_.frame;
  OrientedBox sensed = chassis_box_;
  sensed.center = sensed.center + 0.5 * kSensorDeck * frame.up;
  sensed.half.z += 0.5 * kSensorDeck;
  // From the floor to the deck, and as wide and long as chassis and wheels together.
  const double top = std::max(d.top() + kSensorDeck, 2.0 * d.wheel_radius);
  const OrientedBox enclosing{
      frame.point({0.0, 0.0, 0.5 * top}),
      chassis_box_.axes,
      {std::max(0.5 * d.length, d.wheel_radius),
       std::max(0.5 * d.width, d.half_axle() + 0.5 * d.wheel_width), 0.5 * top}};
  const double size = enclosing.half.x + enclosing.half.y + 2.0 * enclosing.half.z;
  const double speed =
      std::sqrt(dot(velocity_, velocity_)) + size * std::sqrt(dot(turning_, turning_));
  scene.place_robot(id, sensed, wheels_, enclosing, step * speed + kSlack);
}

}  // namespace elsie::physics

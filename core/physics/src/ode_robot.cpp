#include "ode_robot.h"

#include <cmath>
#include <numbers>

#include "elsie/world/engine_facts.h"

#include "bounds.h"

namespace elsie::physics {
namespace {

// ODE's solver gives up where two motors of equal strength reach their limits at the same instant.
constexpr double kTieBreaker = 1e-6;

constexpr double kHalfSqrt2 = 0.5 * std::numbers::sqrt2;

bool is_finite(const Vector3& v) { return std::isfinite(v.x + v.y + v.z); }

/// The frame of a robot that stands there.
Frame standing(const Pose& pose, double z) {
  const double c = std::cos(pose.heading_rad), s = std::sin(pose.heading_rad);
  return {{pose.x, pose.y, z}, {c, s, 0.0}, {-s, c, 0.0}, {0.0, 0.0, 1.0}};
}

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

OdeRobot::OdeRobot(dWorldID world, const world::RobotBody& body,
                   std::span<const world::Segment> segments, const Pose& pose, double z)
    : dimensions_(body),
      caster_radius_(world::caster_radius(body)),
      caster_x_(world::half_base(body)),
      lever_(lever_of(body, segments)),
      couplings_(world::couplings(body, segments)) {
  const auto make = [&](Part part, dGeomID geom, const dMass& mass) {
    const dBodyID made = dBodyCreate(world);
    dBodySetMass(made, &mass);
    dBodySetFiniteRotationMode(made, 1);
    dGeomSetBody(geom, made);
    bodies_[part] = made;
    geoms_[part].reset(geom);
  };
  dMass mass;
  dMassSetBoxTotal(&mass, body.mass, body.length, body.width, body.height);
  make(chassis, dCreateBox(nullptr, body.length, body.width, body.height), mass);
  dMassSetCylinderTotal(&mass, body.wheel_mass, 3, body.wheel_radius, body.wheel_width);
  for (const Part part : {left_wheel, right_wheel}) {
    make(part, dCreateCylinder(nullptr, body.wheel_radius, body.wheel_width), mass);
  }
  dMassSetSphereTotal(&mass, world::kCasterMass * body.mass, caster_radius_);
  for (const Part part : {front_caster, rear_caster}) {
    make(part, dCreateSphere(nullptr, caster_radius_), mass);
  }
  for (std::size_t i = 0; i < segments.size(); ++i) {
    segments_.emplace_back(world, segments[i], couplings_[i]);
  }
  put(pose, z);
  const Frame frame = standing(pose, z);
  link_wheels(world, frame);
  link_casters(world, frame);
  dBodyID front = bodies_[chassis];
  for (OdeSegment& segment : segments_) {
    segment.link(world, front);
    front = segment.body();
  }
}

void OdeRobot::put(const Pose& pose, double z) {
  const world::RobotBody& d = dimensions_;
  const Frame frame = standing(pose, z);
  const dQuaternion facing{std::cos(0.5 * pose.heading_rad), 0.0, 0.0,
                           std::sin(0.5 * pose.heading_rad)};
  dQuaternion upright_wheel, wheel_facing;
  wheel_rotation(0.0, upright_wheel);
  dQMultiply0(wheel_facing, facing, upright_wheel);
  const auto stand = [&](Part part, const Vector3& place, const dQuaternion rotation) {
    const Vector3 at = frame.point(place);
    dBodySetPosition(bodies_[part], at.x, at.y, at.z);
    dBodySetQuaternion(bodies_[part], rotation);
    dBodySetLinearVel(bodies_[part], 0.0, 0.0, 0.0);
    dBodySetAngularVel(bodies_[part], 0.0, 0.0, 0.0);
  };
  stand(chassis, {0.0, 0.0, d.clearance + 0.5 * d.height}, facing);
  stand(left_wheel, {0.0, d.half_axle(), d.wheel_radius}, wheel_facing);
  stand(right_wheel, {0.0, -d.half_axle(), d.wheel_radius}, wheel_facing);
  stand(front_caster, {caster_x_, 0.0, caster_radius_}, facing);
  stand(rear_caster, {-caster_x_, 0.0, caster_radius_}, facing);
  wheel_angles_ = {};
  velocity_ = turning_ = {};
  state_ = {};
  read_shape(bodies_[chassis], dimensions_, state_, chassis_box_, wheels_);
  for (OdeSegment& segment : segments_) segment.put(frame);
}

void OdeRobot::link_wheels(dWorldID world, const Frame& frame) {
  for (std::size_t i = 0; i < 2; ++i) {
    const dJointID hinge = dJointCreateHinge(world, nullptr);
    dJointAttach(hinge, bodies_[left_wheel + i], bodies_[chassis]);
    const double y = (i == 0 ? 1.0 : -1.0) * dimensions_.half_axle();
    const Vector3 at = frame.point({0.0, y, dimensions_.wheel_radius});
    dJointSetHingeAnchor(hinge, at.x, at.y, at.z);
    dJointSetHingeAxis(hinge, frame.left.x, frame.left.y, frame.left.z);
    const double torque = dimensions_.wheel_torque * (i == 0 ? 1.0 : 1.0 + kTieBreaker);
    dJointSetHingeParam(hinge, dParamFMax, torque);
    dJointSetHingeParam(hinge, dParamVel, 0.0);
    hinges_[i] = hinge;
  }
}

void OdeRobot::link_casters(dWorldID world, const Frame& frame) {
  for (const Part part : {front_caster, rear_caster}) {
    const dJointID ball = dJointCreateBall(world, nullptr);
    dJointAttach(ball, bodies_[part], bodies_[chassis]);
    const double x = part == front_caster ? caster_x_ : -caster_x_;
    const Vector3 at = frame.point({x, 0.0, caster_radius_});
    dJointSetBallAnchor(ball, at.x, at.y, at.z);
  }
}

void OdeRobot::set_wheel_rates(const MotorCommand& rates) {
  dJointSetHingeParam(hinges_[0], dParamVel, rates.left);
  dJointSetHingeParam(hinges_[1], dParamVel, rates.right);
}

OdeRobot::Parts OdeRobot::parts() const {
  return {bodies_[chassis],
          {bodies_[left_wheel], bodies_[right_wheel]},
          {bodies_[front_caster], bodies_[rear_caster]},
          hinges_};
}

void OdeRobot::stop_at_limits(double step) {
  for (OdeSegment& segment : segments_) segment.stop_at_limit(step);
}

void OdeRobot::meet_floor(OdeContacts& contacts, dGeomID floor) const {
  for (std::size_t i = 0; i < 2; ++i) {
    const dBodyID wheel = bodies_[left_wheel + i];
    const double sinking = -dBodyGetLinearVel(wheel)[2];
    contacts.wheel_on_floor(wheel, geoms_[left_wheel + i].get(), wheels_[i], sinking,
                            WheelDrive::motor, floor);
  }
  for (const Part part : {front_caster, rear_caster}) {
    Vector3 lowest = to_vector(dBodyGetPosition(bodies_[part]));
    lowest.z -= caster_radius_;
    if (lowest.z <= contacts.margin(-dBodyGetLinearVel(bodies_[part])[2])) {
      contacts.caster_on_floor(bodies_[part], lowest);
    }
  }
  contacts.box_on_floor(bodies_[chassis], chassis_box_);
  for (const OdeSegment& segment : segments_) segment.meet_floor(contacts, floor);
}

bool OdeRobot::settle(double step) {
  if (!settle_chassis(step)) return false;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const world::Coupling& next = couplings_[i];
    const Frame& front = i == 0 ? state_.frame : segments_[i - 1].state().frame;
    const Vector3 joint = front.point({-next.behind, 0.0, next.height});
    if (!segments_[i].settle(front, joint)) return false;
  }
  return true;
}

bool OdeRobot::settle_chassis(double step) {
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
  read_shape(bodies_[chassis], dimensions_, state_, chassis_box_, wheels_);
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

Vehicle OdeRobot::vehicle(std::size_t index) const {
  if (index > 0) return segments_[index - 1].vehicle();
  Vehicle vehicle;
  vehicle.box = {bodies_[chassis], geoms_[chassis].get(), SolidKind::box, chassis_box_};
  for (std::size_t i = 0; i < 2; ++i) {
    vehicle.wheels[i] = wheel_solid(bodies_[left_wheel + i], geoms_[left_wheel + i].get(),
                                    wheels_[i], chassis_box_);
    vehicle.casters[i] = {
        bodies_[front_caster + i], geoms_[front_caster + i].get(), SolidKind::box, {}};
  }
  const world::RobotBody& d = dimensions_;
  vehicle.wheels_in_box = d.half_axle() + 0.5 * d.wheel_width <= 0.5 * d.width &&
                          d.wheel_radius <= 0.5 * d.length && 2.0 * d.wheel_radius <= d.top();
  vehicle.caster_count = 2;
  return vehicle;
}

void OdeRobot::place_in(Scene& scene, std::size_t vehicle, Scene::Id id, double step) const {
  if (vehicle > 0) {
    segments_[vehicle - 1].place_in(scene, id, step);
  } else {
    place_vehicle(scene, id, {state_.frame, chassis_box_, wheels_, velocity_, turning_}, step);
  }
}

}  // namespace elsie::physics

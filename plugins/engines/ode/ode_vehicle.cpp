#include "ode_vehicle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "body_states.h"
#include "part_bodies.h"
#include "steering.h"

namespace elsie::physics {
namespace {

// ODE's solver gives up where two motors of equal strength reach their limits at the same instant.
constexpr double kTieBreaker = 1e-6;

// The additional distance that it may move in a step because it is accelerated.
constexpr double kRobotSlack = 1e-3;  // m

// A wheel that is flush with the side of the chassis is inside.
constexpr double kFlush = 1e-9;  // m

constexpr double kHalfSqrt2 = 0.5 * std::numbers::sqrt2;

/// The orientation of a wheel that is turned by `angle` about the vehicle's y axis, in the
/// vehicle's frame. ODE's cylinders lie along their z axis.
void wheel_rotation(double angle, dQuaternion q) {
  const double c = std::cos(0.5 * angle) * kHalfSqrt2, s = std::sin(0.5 * angle) * kHalfSqrt2;
  q[0] = c;
  q[1] = -c;
  q[2] = s;
  q[3] = s;
}

void multiply(dQuaternion result, const dQuaternion a, const dQuaternion b) {
  dQuaternion product;
  dQMultiply0(product, a, b);
  std::copy(product, product + 4, result);
}

}  // namespace

OdeVehicle::OdeVehicle(dWorldID world, std::span<const Part> parts) {
  const Part& chassis = parts.front();
  shape_ = chassis.shape;
  middle_ = chassis.frame.origin;
  chassis_geom_ = make_geom(shape_, convex_);
  chassis_ = make_body(world, chassis_geom_.get(), mass_of(shape_, chassis.mass));
  lay(chassis_geom_.get(), shape_);
  if (const auto* hitch = std::get_if<HitchJoint>(&chassis.joint)) hitch_ = *hitch;
  solids_.chassis = {chassis_, chassis_geom_.get(), kind_of(shape_), {}};
  solids_.chassis.shape.half = 0.5 * shape_.size;
  for (const Part& part : parts) {
    if (const auto* wheel = std::get_if<WheelJoint>(&part.joint)) add_wheel(world, part, *wheel);
  }
  for (const Part& part : parts) {
    if (std::holds_alternative<CasterJoint>(part.joint)) add_caster(world, part);
  }
  composite_ = composite_of(parts);
  solids_.wheels_inside = wheels_are_inside();
}

bool OdeVehicle::wheels_are_inside() const {
  if (solids_.chassis.kind != SolidKind::box && solids_.chassis.kind != SolidKind::pillar) {
    return false;
  }
  const Vector3& size = shape_.size;
  const double top = middle_.z + 0.5 * size.z;
  return std::all_of(wheels_.begin(), wheels_.end(), [&](const Wheel& wheel) {
    const Vector3& at = wheel.part.frame.origin;
    const Vector3& own = wheel.part.shape.size;
    const double ahead = std::abs(at.x) + 0.5 * own.x, aside = std::abs(at.y) + 0.5 * own.y;
    const bool is_within = shape_.is_round()
                               ? std::hypot(ahead, aside) <= shape_.radius() + kFlush
                               : ahead <= 0.5 * size.x && aside <= 0.5 * size.y + kFlush;
    return !wheel.joint.steered && is_within && at.z + 0.5 * own.z <= top;
  });
}

void OdeVehicle::add_wheel(dWorldID world, const Part& part, const WheelJoint& joint) {
  const double radius = part.shape.radius(), width = part.shape.length();
  Wheel& wheel = wheels_.emplace_back();
  wheel.part = part;
  wheel.joint = joint;
  wheel.rest_rad = std::atan2(part.frame.forward.y, part.frame.forward.x);
  wheel.geom.reset(dCreateCylinder(nullptr, radius, width));
  if (joint.torque > 0.0) {
    dMass mass;
    dMassSetCylinderTotal(&mass, part.mass, 3, radius, width);
    wheel.about_axle = mass.I[10];
    wheel.motor = Motor{make_body(world, wheel.geom.get(), mass), nullptr};
  } else {
    dGeomSetBody(wheel.geom.get(), chassis_);
    const Vector3 at = part.frame.origin - middle_;
    dGeomSetOffsetPosition(wheel.geom.get(), at.x, at.y, at.z);
  }
  wheel_shapes_.push_back({{}, {}, radius, 0.5 * width});
  solids_.wheels.push_back({wheel.motor ? wheel.motor->body : chassis_,
                            wheel.geom.get(),
                            SolidKind::wheel,
                            {{}, {}, {radius, 0.5 * width, radius}}});
}

void OdeVehicle::add_caster(dWorldID world, const Part& part) {
  const double radius = part.shape.radius();
  dMass mass;
  dMassSetSphereTotal(&mass, part.mass, radius);
  const dGeomID geom = dCreateSphere(nullptr, radius);
  caster_geoms_.emplace_back(geom);
  casters_.push_back(make_body(world, geom, mass));
  caster_places_.push_back(part.frame.origin);
  caster_radii_.push_back(radius);
  solids_.casters.push_back({casters_.back(), geom, SolidKind::box, {}});
}

void OdeVehicle::put(const Frame& frame, double heading_rad) {
  const Vector3 center = frame.point(middle_);
  dBodySetPosition(chassis_, center.x, center.y, center.z);
  dQuaternion facing{std::cos(0.5 * heading_rad), 0.0, 0.0, std::sin(0.5 * heading_rad)};
  if (hitch_) {
    set_rotation(chassis_, frame);
    std::copy_n(dBodyGetQuaternion(chassis_), 4, facing);
  } else {
    dBodySetQuaternion(chassis_, facing);
  }
  stop(chassis_);
  velocity_ = turning_ = {};
  hitch_state_.yaw_rad = hitch_state_.pitch_rad = 0.0;
  for (Wheel& wheel : wheels_) {
    wheel.now = {};
    wheel.turned = 0.0;
    if (!wheel.motor) {
      turn_geom(wheel);
      continue;
    }
    const Vector3 at = frame.point(wheel.part.frame.origin);
    dBodySetPosition(wheel.motor->body, at.x, at.y, at.z);
    turn_wheel(wheel, facing);
    stop(wheel.motor->body);
  }
  for (std::size_t i = 0; i < casters_.size(); ++i) {
    const Vector3 at = frame.point(caster_places_[i]);
    dBodySetPosition(casters_[i], at.x, at.y, at.z);
    dBodySetQuaternion(casters_[i], facing);
    stop(casters_[i]);
  }
  read_frame();
  read_shapes();
}

void OdeVehicle::take(const OdeVehicle& other) {
  copy_state(other.chassis_, chassis_);
  for (std::size_t i = 0; i < casters_.size(); ++i) copy_state(other.casters_[i], casters_[i]);
  frame_ = other.frame_;
  velocity_ = other.velocity_;
  turning_ = other.turning_;
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    Wheel& wheel = wheels_[i];
    const Wheel& same = other.wheels_[i];
    wheel.now = same.now;
    wheel.wanted = same.wanted;
    wheel.turned = same.turned;
  }
  read_shapes();
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const Wheel& wheel = wheels_[i];
    if (!wheel.motor) {
      turn_geom(wheel);
      continue;
    }
    copy_state(other.wheels_[i].motor->body, wheel.motor->body);
    dJointSetHingeParam(wheel.motor->hinge, dParamVel, wheel.wanted.rate_rad_s);
    if (wheel.joint.steered) {
      const Vector3& axis = wheel_shapes_[i].axis;
      dJointSetHingeAxis(wheel.motor->hinge, axis.x, axis.y, axis.z);
    }
  }
  const dJointID joint = hitch_state_.joint;
  hitch_state_ = other.hitch_state_;
  hitch_state_.joint = joint;
  if (hitch_state_.stopping) dJointSetUniversalParam(joint, dParamFMax1, dInfinity);
}

void OdeVehicle::push(const Vector3& velocity, const Vector3& turning, const Vector3& middle) {
  const auto set = [&](dBodyID body) {
    const Vector3 v = velocity + cross(turning, to_vector(dBodyGetPosition(body)) - middle);
    dBodySetLinearVel(body, v.x, v.y, v.z);
    dBodySetAngularVel(body, turning.x, turning.y, turning.z);
  };
  for_each_body(set);
  velocity_ = to_vector(dBodyGetLinearVel(chassis_));
  turning_ = turning;
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    Wheel& wheel = wheels_[i];
    if (!wheel.motor) continue;
    const Cylinder& shape = wheel_shapes_[i];
    const Vector3 v = to_vector(dBodyGetLinearVel(wheel.motor->body));
    // It rolls.
    wheel.now.rate_rad_s = dot(v, cross(shape.axis, frame_.up)) / shape.radius;
    const Vector3 w = turning_ + wheel.now.rate_rad_s * shape.axis;
    dBodySetAngularVel(wheel.motor->body, w.x, w.y, w.z);
  }
}

/// The direction of a wheel in the vehicle's frame, rad.
double OdeVehicle::heading_of(const Wheel& wheel) { return wheel.rest_rad + wheel.now.angle_rad; }

void OdeVehicle::turn_wheel(const Wheel& wheel, const dQuaternion chassis) const {
  dQuaternion own, q;
  wheel_rotation(wheel.turned, own);
  if (const double heading = heading_of(wheel); heading != 0.0) {
    const dQuaternion steered{std::cos(0.5 * heading), 0.0, 0.0, std::sin(0.5 * heading)};
    multiply(own, steered, own);
  }
  dQMultiply0(q, chassis, own);
  dBodySetQuaternion(wheel.motor->body, q);
}

/// Turns the geometry of a wheel without a body of its own.
void OdeVehicle::turn_geom(const Wheel& wheel) const {
  dQuaternion along_axle, turned;
  dQFromAxisAndAngle(along_axle, 1.0, 0.0, 0.0, 0.5 * std::numbers::pi);
  const double half = 0.5 * heading_of(wheel);
  const dQuaternion steered{std::cos(half), 0.0, 0.0, std::sin(half)};
  dQMultiply0(turned, steered, along_axle);
  dGeomSetOffsetQuaternion(wheel.geom.get(), turned);
}

void OdeVehicle::link(dWorldID world, dBodyID front, const Frame& frame) {
  link_wheels(world, frame);
  for (std::size_t i = 0; i < casters_.size(); ++i) {
    const dJointID ball = dJointCreateBall(world, nullptr);
    dJointAttach(ball, casters_[i], chassis_);
    const Vector3 at = frame.point(caster_places_[i]);
    dJointSetBallAnchor(ball, at.x, at.y, at.z);
  }
  if (hitch_) link_hitch(world, front);
}

void OdeVehicle::link_wheels(dWorldID world, const Frame& frame) {
  double number = 0.0;
  for (Wheel& wheel : wheels_) {
    if (!wheel.motor) continue;
    const dJointID hinge = dJointCreateHinge(world, nullptr);
    dJointAttach(hinge, wheel.motor->body, chassis_);
    const Vector3 at = frame.point(wheel.part.frame.origin);
    const Vector3 axis = frame.direction(wheel.part.frame.left);
    dJointSetHingeAnchor(hinge, at.x, at.y, at.z);
    dJointSetHingeAxis(hinge, axis.x, axis.y, axis.z);
    dJointSetHingeParam(hinge, dParamFMax, wheel.joint.torque * (1.0 + number * kTieBreaker));
    dJointSetHingeParam(hinge, dParamVel, 0.0);
    wheel.motor->hinge = hinge;
    number += 1.0;
  }
}

std::span<const JointSetting> OdeVehicle::set(std::span<const JointSetting> settings) {
  if (hitch_ && hitch_->torque > 0.0) {
    hitch_state_.wanted_yaw_rad =
        std::clamp(settings.front().angle_rad, -hitch_->max_yaw_rad, hitch_->max_yaw_rad);
    settings = settings.subspan(1);
  }
  for (Wheel& wheel : wheels_) {
    if (!wheel.motor && !wheel.joint.steered) continue;
    wheel.wanted = settings.front();
    settings = settings.subspan(1);
    if (wheel.motor) dJointSetHingeParam(wheel.motor->hinge, dParamVel, wheel.wanted.rate_rad_s);
  }
  return settings;
}

void OdeVehicle::begin_step(double step) {
  for (Wheel& wheel : wheels_) {
    if (wheel.joint.steered) steer(wheel, step);
  }
  if (hitch_) begin_hitch(step);
}

void OdeVehicle::steer(Wheel& wheel, double step) {
  const WheelJoint& joint = wheel.joint;
  if (!physics::steer(wheel.now, wheel.wanted, joint.max_steer_rad, joint.steer_rate_rad_s, step)) {
    return;
  }
  read_shapes();
  if (wheel.motor) {
    turn_wheel(wheel, dBodyGetQuaternion(chassis_));
    const Vector3& axis = wheel_shapes_[static_cast<std::size_t>(&wheel - wheels_.data())].axis;
    dJointSetHingeAxis(wheel.motor->hinge, axis.x, axis.y, axis.z);
  } else {
    turn_geom(wheel);
  }
}

void OdeVehicle::meet_floor(OdeContacts& contacts, dGeomID floor) const {
  // ODE computes the place of a geometry that is off its body's middle when it is first asked for,
  // which later several threads may do at once.
  for (const Wheel& wheel : wheels_) {
    if (!wheel.motor) dGeomGetPosition(wheel.geom.get());
  }
  if (solids_.chassis.kind == SolidKind::wheel || solids_.chassis.kind == SolidKind::capsule) {
    dGeomGetPosition(chassis_geom_.get());
  }
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const Wheel& wheel = wheels_[i];
    const Cylinder& shape = wheel_shapes_[i];
    if (wheel.motor) {
      const double sinking = -dBodyGetLinearVel(wheel.motor->body)[2];
      contacts.wheel_on_floor(wheel.motor->body, wheel.geom.get(), shape, sinking, wheel.joint,
                              floor);
    } else {
      const double sinking =
          -(velocity_ + cross(turning_, shape.center - solids_.chassis.shape.center)).z;
      contacts.wheel_on_floor(chassis_, wheel.geom.get(), shape, sinking, wheel.joint, floor);
    }
  }
  for (std::size_t i = 0; i < casters_.size(); ++i) {
    Vector3 lowest = to_vector(dBodyGetPosition(casters_[i]));
    lowest.z -= caster_radii_[i];
    if (lowest.z <= contacts.margin(-dBodyGetLinearVel(casters_[i])[2])) {
      contacts.caster_on_floor(casters_[i], lowest);
    }
  }
  contacts.solid_on_floor(chassis_, shape_, solids_.chassis.shape);
}

bool OdeVehicle::settle(double step, const Frame* front) {
  velocity_ = to_vector(dBodyGetLinearVel(chassis_));
  turning_ = to_vector(dBodyGetAngularVel(chassis_));
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    Wheel& wheel = wheels_[i];
    if (!wheel.motor) continue;
    const Vector3 spin = to_vector(dBodyGetAngularVel(wheel.motor->body));
    wheel.now.rate_rad_s = dot(wheel_shapes_[i].axis, spin - turning_);
    if (!std::isfinite(wheel.now.rate_rad_s)) return false;
    wheel.turned =
        std::remainder(wheel.turned + step * wheel.now.rate_rad_s, 2.0 * std::numbers::pi);
  }
  if (hitch_) {
    if (!settle_at_hitch(*front)) return false;
  } else {
    read_frame();
  }
  if (!is_finite(frame_.origin) || !is_finite(velocity_) || !is_finite(turning_) ||
      !is_finite(frame_.forward)) {
    return false;
  }
  read_shapes();
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const Wheel& wheel = wheels_[i];
    if (!wheel.motor) continue;
    carry(wheel.motor->body, wheel_shapes_[i].center);
    turn_wheel(wheel, dBodyGetQuaternion(chassis_));
    const Vector3 w = turning_ + wheel.now.rate_rad_s * wheel_shapes_[i].axis;
    dBodySetAngularVel(wheel.motor->body, w.x, w.y, w.z);
  }
  for (std::size_t i = 0; i < casters_.size(); ++i) {
    carry(casters_[i], frame_.point(caster_places_[i]));
  }
  return true;
}

void OdeVehicle::carry(dBodyID body, const Vector3& at) const {
  const Vector3 v = velocity_ + cross(turning_, at - solids_.chassis.shape.center);
  dBodySetPosition(body, at.x, at.y, at.z);
  dBodySetLinearVel(body, v.x, v.y, v.z);
}

/// Reads the frame of the chassis from ODE; everything else follows from it.
void OdeVehicle::read_frame() {
  const dReal* r = dBodyGetRotation(chassis_);
  frame_.forward = {r[0], r[4], r[8]};
  frame_.left = {r[1], r[5], r[9]};
  frame_.up = {r[2], r[6], r[10]};
  frame_.origin = to_vector(dBodyGetPosition(chassis_)) - middle_.z * frame_.up;
}

void OdeVehicle::read_shapes() {
  OrientedBox& box = solids_.chassis.shape;
  box.center = to_vector(dBodyGetPosition(chassis_));
  const std::array axes{frame_.forward, frame_.left, frame_.up};
  if (solids_.chassis.kind != SolidKind::ball) box.axes = axes;
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    const Wheel& wheel = wheels_[i];
    Solid& solid = solids_.wheels[i];
    solid.shape.center = frame_.point(wheel.part.frame.origin);
    solid.shape.axes = axes;
    if (const double angle = heading_of(wheel); angle != 0.0) {
      const double c = std::cos(angle), s = std::sin(angle);
      solid.shape.axes[0] = c * frame_.forward + s * frame_.left;
      solid.shape.axes[1] = c * frame_.left - s * frame_.forward;
    }
    wheel_shapes_[i].center = solid.shape.center;
    wheel_shapes_[i].axis = solid.shape.axes[1];
  }
}

/// Its reach is how far its speed carries it in a step.
bool OdeVehicle::place_in(Scene& scene, Scene::Id id, double step) const {
  const OrientedBox chassis{
      solids_.chassis.shape.center, {frame_.forward, frame_.left, frame_.up}, 0.5 * shape_.size};
  // From the floor to the deck, as wide and long as chassis and wheels together.
  double top = dot(chassis.center - frame_.origin, frame_.up) + chassis.half.z + kSensorDeck;
  double half_length = chassis.half.x, half_width = chassis.half.y;
  double radius = shape_.radius();  // of a round chassis
  for (const Cylinder& wheel : wheel_shapes_) {
    const Vector3 at = wheel.center - frame_.origin;
    const double along = std::abs(dot(wheel.axis, frame_.forward));  // 0: it rolls straight ahead
    const double ahead = along == 0.0 ? wheel.radius : wheel.radius + along * wheel.half_length;
    const double aside =
        along == 0.0 ? wheel.half_length : wheel.half_length + along * wheel.radius;
    const double front = std::abs(dot(at, frame_.forward)) + ahead;
    const double side = std::abs(dot(at, frame_.left)) + aside;
    half_length = std::max(half_length, front);
    half_width = std::max(half_width, side);
    if (shape_.is_round()) radius = std::max(radius, std::hypot(front, side));
    top = std::max(top, 2.0 * wheel.radius);
  }
  const Vector3 half{half_length, half_width, 0.5 * top};
  const Vector3 center = frame_.point({0.0, 0.0, half.z});
  const Aabb enclosing = shape_.is_round() ? bounds(Cylinder{center, frame_.up, radius, half.z})
                                           : bounds(OrientedBox{center, chassis.axes, half});
  const double size = half.x + half.y + 2.0 * half.z;
  const double speed =
      std::sqrt(dot(velocity_, velocity_)) + size * std::sqrt(dot(turning_, turning_));
  SensedSolid sensed(shape_);
  sensed.put(with_deck(shape_, chassis));
  return scene.place_robot(id, sensed, wheel_shapes_, enclosing, step * speed + kRobotSlack);
}

}  // namespace elsie::physics

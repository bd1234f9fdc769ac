#include "ode_segment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace elsie::physics {
namespace {

// How far before its limit ODE's stop of a joint stands, so that a joint that was put to its limit
// is beyond the stop whatever the rounding.
constexpr double kStopSlack = 1e-6;  // rad

/// The unit vector along v, or `otherwise` where there is none.
Vector3 unit(const Vector3& v, const Vector3& otherwise) {
  const double length = std::sqrt(dot(v, v));
  return length > 1e-6 ? (1.0 / length) * v : otherwise;
}

}  // namespace

OdeSegment::OdeSegment(dWorldID world, const world::Segment& segment,
                       const world::Coupling& coupling)
    : dimensions_(segment), coupling_(coupling), body_(dBodyCreate(world)) {
  dMass mass;
  dMassSetBoxTotal(&mass, segment.mass, segment.length, segment.width, segment.height);
  dBodySetMass(body_, &mass);
  dBodySetFiniteRotationMode(body_, 1);
  box_geom_.reset(dCreateBox(nullptr, segment.length, segment.width, segment.height));
  dGeomSetBody(box_geom_.get(), body_);
  for (std::size_t i = 0; i < 2; ++i) {
    const dGeomID wheel = dCreateCylinder(nullptr, segment.wheel_radius, segment.wheel_width);
    wheel_geoms_[i].reset(wheel);
    dGeomSetBody(wheel, body_);
    // ODE's cylinders lie along their z axis.
    dQuaternion along_axle;
    dQFromAxisAndAngle(along_axle, 1.0, 0.0, 0.0, 0.5 * std::numbers::pi);
    dGeomSetOffsetQuaternion(wheel, along_axle);
    dGeomSetOffsetPosition(wheel, 0.0, (i == 0 ? 1.0 : -1.0) * segment.half_axle(),
                           segment.wheel_radius - segment.clearance - 0.5 * segment.height);
  }
}

void OdeSegment::link(dWorldID world, dBodyID front) {
  joint_ = dJointCreateUniversal(world, nullptr);
  dJointAttach(joint_, front, body_);
  const Frame& frame = state_.frame;
  const Vector3 at = frame.point({coupling_.ahead, 0.0, coupling_.height});
  dJointSetUniversalAnchor(joint_, at.x, at.y, at.z);
  dJointSetUniversalAxis1(joint_, frame.up.x, frame.up.y, frame.up.z);
  dJointSetUniversalAxis2(joint_, frame.left.x, frame.left.y, frame.left.z);
  dJointSetUniversalParam(joint_, dParamLoStop1, kStopSlack - coupling_.max_yaw_rad);
  dJointSetUniversalParam(joint_, dParamHiStop1, coupling_.max_yaw_rad - kStopSlack);
  dJointSetUniversalParam(joint_, dParamLoStop2, -coupling_.max_pitch_rad);
  dJointSetUniversalParam(joint_, dParamHiStop2, coupling_.max_pitch_rad);
}

void OdeSegment::stop_at_limit(double step) {
  // ODE's angles of this joint count the other way round: of the front against the segment.
  const double rate = -dJointGetUniversalAngle1Rate(joint_);
  const double limit = std::copysign(coupling_.max_yaw_rad, rate);
  const double room = limit - state_.yaw_rad;
  // ODE would add the torque of a motor to that of an active limit.
  const bool is_there = std::abs(room) <= 2.0 * kStopSlack;
  const bool reaches_it = !is_there && std::abs(rate) * step > std::abs(room);
  if (reaches_it) dJointSetUniversalParam(joint_, dParamVel1, -room / step);
  if (reaches_it != stopping_) {
    dJointSetUniversalParam(joint_, dParamFMax1, reaches_it ? dInfinity : 0.0);
  }
  stopping_ = reaches_it;
}

void OdeSegment::put(const Frame& robot) {
  const Vector3 center =
      robot.point({-coupling_.place, 0.0, dimensions_.clearance + 0.5 * dimensions_.height});
  const Vector3 &f = robot.forward, &l = robot.left, &u = robot.up;
  const dMatrix3 rotation{f.x, l.x, u.x, 0.0, f.y, l.y, u.y, 0.0, f.z, l.z, u.z, 0.0};
  dBodySetPosition(body_, center.x, center.y, center.z);
  dBodySetRotation(body_, rotation);
  dBodySetLinearVel(body_, 0.0, 0.0, 0.0);
  dBodySetAngularVel(body_, 0.0, 0.0, 0.0);
  velocity_ = turning_ = {};
  state_.yaw_rad = state_.pitch_rad = 0.0;
  read_shape(body_, dimensions_, state_, box_, wheels_);
}

void OdeSegment::meet_floor(OdeContacts& contacts, dGeomID floor) const {
  for (std::size_t i = 0; i < 2; ++i) {
    const double sinking = -(velocity_ + cross(turning_, wheels_[i].center - box_.center)).z;
    contacts.wheel_on_floor(body_, wheel_geoms_[i].get(), wheels_[i], sinking, WheelDrive::free,
                            floor);
  }
  contacts.box_on_floor(body_, box_);
}

bool OdeSegment::settle(const Frame& front, const Vector3& joint) {
  velocity_ = to_vector(dBodyGetLinearVel(body_));
  turning_ = to_vector(dBodyGetAngularVel(body_));
  const dReal* r = dBodyGetRotation(body_);
  Frame& frame = state_.frame;
  // Its transverse axis stays at right angles to the vertical of the body in front: no roll.
  const Vector3 left{r[1], r[5], r[9]};
  frame.left = unit(left - dot(left, front.up) * front.up, left);
  const Vector3 forward{r[0], r[4], r[8]};
  frame.forward = unit(forward - dot(forward, frame.left) * frame.left, forward);
  frame.up = cross(frame.forward, frame.left);
  limit_joint(front);

  const Vector3 origin = joint - coupling_.ahead * frame.forward - coupling_.height * frame.up;
  const Vector3 center = origin + (dimensions_.clearance + 0.5 * dimensions_.height) * frame.up;
  const Vector3 &f = frame.forward, &l = frame.left, &u = frame.up;
  if (!std::isfinite(dot(center, center) + dot(velocity_, velocity_) + dot(turning_, turning_) +
                     dot(f, f) + dot(l, l))) {
    return false;
  }
  const dMatrix3 rotation{f.x, l.x, u.x, 0.0, f.y, l.y, u.y, 0.0, f.z, l.z, u.z, 0.0};
  dBodySetRotation(body_, rotation);
  dBodySetPosition(body_, center.x, center.y, center.z);
  read_shape(body_, dimensions_, state_, box_, wheels_);
  return true;
}

void OdeSegment::limit_joint(const Frame& front) {
  Frame& frame = state_.frame;
  const double yaw = std::atan2(dot(frame.forward, front.left), dot(frame.forward, front.forward));
  // From where it was, so that it does not come round the back.
  const double turned = state_.yaw_rad + wrap_angle(yaw - state_.yaw_rad);
  const double pitch = std::asin(std::clamp(dot(frame.forward, front.up), -1.0, 1.0));
  state_.yaw_rad = std::clamp(turned, -coupling_.max_yaw_rad, coupling_.max_yaw_rad);
  state_.pitch_rad = std::clamp(pitch, -coupling_.max_pitch_rad, coupling_.max_pitch_rad);
  if (state_.yaw_rad == turned && state_.pitch_rad == pitch) return;
  const Frame limited = front.frame(Frame::turned({}, state_.yaw_rad, state_.pitch_rad));
  frame.forward = limited.forward;
  frame.left = limited.left;
  frame.up = limited.up;
}

void OdeSegment::place_in(Scene& scene, Scene::Id id, double step) const {
  place_vehicle(scene, id, {state_.frame, box_, wheels_, velocity_, turning_}, step);
}

Vehicle OdeSegment::vehicle() const {
  const world::Segment& d = dimensions_;
  Vehicle vehicle;
  vehicle.box = {body_, box_geom_.get(), SolidKind::box, box_};
  for (std::size_t i = 0; i < 2; ++i) {
    vehicle.wheels[i] = wheel_solid(body_, wheel_geoms_[i].get(), wheels_[i], box_);
  }
  vehicle.wheels_in_box = d.wheel_radius <= 0.5 * d.length && 2.0 * d.wheel_radius <= d.top();
  return vehicle;
}

}  // namespace elsie::physics

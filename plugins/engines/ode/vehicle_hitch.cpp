// The joint by which a vehicle hangs on the one in front.
#include <algorithm>
#include <cmath>

#include "ode_vehicle.h"
#include "part_bodies.h"

namespace elsie::physics {
namespace {

// ODE's stop of a joint stands before the joint's limit by this angle, so that a joint at its limit
// is beyond the stop despite rounding.
constexpr double kStopSlack = 1e-6;  // rad

/// The unit vector along v, or `otherwise` where there is none.
Vector3 unit(const Vector3& v, const Vector3& otherwise) {
  const double length = std::sqrt(dot(v, v));
  return length > 1e-6 ? (1.0 / length) * v : otherwise;
}

}  // namespace

void OdeVehicle::link_hitch(dWorldID world, dBodyID front) {
  const dJointID joint = dJointCreateUniversal(world, nullptr);
  hitch_state_.joint = joint;
  dJointAttach(joint, front, chassis_);
  const Vector3 at = hitch_place();
  dJointSetUniversalAnchor(joint, at.x, at.y, at.z);
  dJointSetUniversalAxis1(joint, frame_.up.x, frame_.up.y, frame_.up.z);
  dJointSetUniversalAxis2(joint, frame_.left.x, frame_.left.y, frame_.left.z);
  dJointSetUniversalParam(joint, dParamLoStop1, kStopSlack - hitch_->max_yaw_rad);
  dJointSetUniversalParam(joint, dParamHiStop1, hitch_->max_yaw_rad - kStopSlack);
  dJointSetUniversalParam(joint, dParamLoStop2, -hitch_->max_pitch_rad);
  dJointSetUniversalParam(joint, dParamHiStop2, hitch_->max_pitch_rad);
}

void OdeVehicle::begin_hitch(double step) {
  // ODE counts the angles of this joint the other way round: of the front against the one behind.
  const dJointID joint = hitch_state_.joint;
  if (hitch_->torque > 0.0) {
    const double off = hitch_state_.wanted_yaw_rad - hitch_state_.yaw_rad;
    hitch_state_.rate = std::clamp(off / step, -hitch_->yaw_rate_rad_s, hitch_->yaw_rate_rad_s);
    dJointSetUniversalParam(joint, dParamVel1, -hitch_state_.rate);
    dJointSetUniversalParam(joint, dParamFMax1, hitch_->torque);
    return;
  }
  const double rate = -dJointGetUniversalAngle1Rate(joint);
  const double limit = std::copysign(hitch_->max_yaw_rad, rate);
  const double room = limit - hitch_state_.yaw_rad;
  // ODE would add the torque of a motor to that of an active limit.
  const bool is_there = std::abs(room) <= 2.0 * kStopSlack;
  const bool reaches_it = !is_there && std::abs(rate) * step > std::abs(room);
  if (reaches_it) dJointSetUniversalParam(joint, dParamVel1, -room / step);
  if (reaches_it != hitch_state_.stopping) {
    dJointSetUniversalParam(joint, dParamFMax1, reaches_it ? dInfinity : 0.0);
  }
  hitch_state_.stopping = reaches_it;
}

bool OdeVehicle::settle_at_hitch(const Frame& front) {
  const Vector3 joint = front.point({-hitch_->behind, 0.0, hitch_->height});
  const dReal* r = dBodyGetRotation(chassis_);
  // The transverse axis stays at right angles to the vertical of the body in front: no roll.
  const Vector3 left{r[1], r[5], r[9]};
  frame_.left = unit(left - dot(left, front.up) * front.up, left);
  const Vector3 forward{r[0], r[4], r[8]};
  frame_.forward = unit(forward - dot(forward, frame_.left) * frame_.left, forward);
  frame_.up = cross(frame_.forward, frame_.left);
  limit_hitch(front);

  const Vector3 origin = joint - hitch_->ahead * frame_.forward - hitch_->height * frame_.up;
  const Vector3 center = origin + middle_.z * frame_.up;
  if (!is_finite(center) || !is_finite(frame_.forward) || !is_finite(frame_.left)) return false;
  set_rotation(chassis_, frame_);
  dBodySetPosition(chassis_, center.x, center.y, center.z);
  read_frame();
  return true;
}

void OdeVehicle::limit_hitch(const Frame& front) {
  HitchState& state = hitch_state_;
  const double yaw =
      std::atan2(dot(frame_.forward, front.left), dot(frame_.forward, front.forward));
  // Relative to the last angle, so that it does not jump by a full turn.
  const double turned = state.yaw_rad + wrap_angle(yaw - state.yaw_rad);
  const double pitch = std::asin(std::clamp(dot(frame_.forward, front.up), -1.0, 1.0));
  state.yaw_rad = std::clamp(turned, -hitch_->max_yaw_rad, hitch_->max_yaw_rad);
  state.pitch_rad = std::clamp(pitch, -hitch_->max_pitch_rad, hitch_->max_pitch_rad);
  if (state.yaw_rad == turned && state.pitch_rad == pitch) return;
  const Frame limited = front.frame(Frame::turned({}, state.yaw_rad, state.pitch_rad));
  frame_.forward = limited.forward;
  frame_.left = limited.left;
  frame_.up = limited.up;
}

}  // namespace elsie::physics

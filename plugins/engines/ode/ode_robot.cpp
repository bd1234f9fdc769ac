#include "ode_robot.h"

#include <algorithm>
#include <cmath>

#include "elsie/world/parts.h"

#include "bounds.h"

namespace elsie::physics {
namespace {

/// The frame of a robot that stands at this pose.
Frame standing(const Pose& pose, double z) {
  const double c = std::cos(pose.heading_rad), s = std::sin(pose.heading_rad);
  return {{pose.x, pose.y, z}, {c, s, 0.0}, {-s, c, 0.0}, {0.0, 0.0, 1.0}};
}

Pose on_floor(const Frame& frame) {
  return {frame.origin.x, frame.origin.y, std::atan2(frame.forward.y, frame.forward.x)};
}

}  // namespace

OdeRobot::OdeRobot(dWorldID world, const BodyPlan& plan, const Pose& pose, double z)
    : plan_(plan), made_at_(pose), made_z_(z), lever_(lever_of(plan)) {
  for (auto first = plan_.parts.begin(); first != plan_.parts.end();) {
    const auto last = std::find_if(
        first, plan_.parts.end(), [&](const Part& part) { return part.vehicle != first->vehicle; });
    vehicles_.emplace_back(world, std::span(first, last));
    first = last;
  }
  for (const Part& part : plan_.parts) {
    height_ = std::max(height_, part.frame.origin.z + 0.5 * part.shape.size.z);
    if (!can_be_set(part.joint)) continue;
    joints_.emplace_back();
    radii_.push_back(std::holds_alternative<WheelJoint>(part.joint) ? part.shape.radius() : 0.0);
  }
  put(pose, z);
  const Frame frame = standing(pose, z);
  dBodyID front = nullptr;
  for (OdeVehicle& vehicle : vehicles_) {
    vehicle.link(world, front, vehicle.hitch() ? vehicle.frame() : frame);
    front = vehicle.chassis();
  }
}

OdeRobot::OdeRobot(dWorldID world, const OdeRobot& other)
    : OdeRobot(world, other.plan_, other.made_at_, other.made_z_) {
  for (std::size_t i = 0; i < vehicles_.size(); ++i) vehicles_[i].take(other.vehicles_[i]);
  joints_ = other.joints_;
  wanted_ = other.wanted_;
  state_ = other.state_;
}

void OdeRobot::push(const OdeRobot& other) {
  const OdeVehicle& first = other.vehicles_.front();
  const Vector3 middle = to_vector(dBodyGetPosition(first.chassis()));
  for (OdeVehicle& vehicle : vehicles_) {
    vehicle.push(first.velocity(), first.turning(), middle);
  }
  read_state();
}

void OdeRobot::put(const Pose& pose, double z) {
  const Frame frame = standing(pose, z);
  const std::vector<Frame> frames = world::in_line(plan_);
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    vehicles_[i].put(i == 0 ? frame : frame.frame(frames[i]), pose.heading_rad);
  }
  read_state();
}

void OdeRobot::set_joints(std::span<const JointSetting> settings) {
  wanted_.assign(settings.begin(), settings.end());
}

void OdeRobot::begin_step(double step) {
  if (!wanted_.empty()) {
    std::span<const JointSetting> settings = wanted_;
    for (OdeVehicle& vehicle : vehicles_) settings = vehicle.set(settings);
    wanted_.clear();
  }
  for (OdeVehicle& vehicle : vehicles_) vehicle.begin_step(step);
}

void OdeRobot::meet_floor(OdeContacts& contacts, dGeomID floor) const {
  for (const OdeVehicle& vehicle : vehicles_) vehicle.meet_floor(contacts, floor);
}

bool OdeRobot::settle(double step) {
  const Frame* front = nullptr;
  for (OdeVehicle& vehicle : vehicles_) {
    if (!vehicle.settle(step, front)) return false;
    front = &vehicle.frame();
  }
  read_state();
  return true;
}

void OdeRobot::read_state() {
  const OdeVehicle& first = vehicles_.front();
  state_.frame = first.frame();
  state_.pose = on_floor(state_.frame);
  state_.speed = dot(first.velocity(), state_.frame.forward);
  state_.lateral = dot(first.velocity(), state_.frame.left);
  state_.turn_rate = first.turning().z;
  auto joint = joints_.begin();
  for (const OdeVehicle& vehicle : vehicles_) {
    if (vehicle.hitch() && vehicle.hitch()->torque > 0.0) joint++->angle_rad = vehicle.yaw_rad();
    for (const OdeVehicle::Wheel& wheel : vehicle.wheels()) {
      if (can_be_set(wheel.joint)) *joint++ = wheel.now;
    }
  }
}

SegmentState OdeRobot::segment(std::size_t segment) const {
  const OdeVehicle& vehicle = vehicles_.at(segment + 1);
  return {vehicle.frame(), on_floor(vehicle.frame()), vehicle.yaw_rad(), vehicle.pitch_rad()};
}

double OdeRobot::most_speed(std::span<const JointSetting> settings) const {
  double rim = 0.0;
  for (std::size_t i = 0; i < radii_.size(); ++i) {
    rim = std::max(rim, radii_[i] * std::abs(settings[i].rate_rad_s));
  }
  return lever_ * rim;
}

}  // namespace elsie::physics

#include "planar_robot.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "elsie/world/parts.h"

#include "bounds.h"

namespace elsie::physics {
namespace {

/// Moves a value towards another one by at most `most`.
double approach(double from, double to, double most) {
  return std::abs(to - from) <= most ? to : from + std::copysign(most, to - from);
}

}  // namespace

PlanarRobot::PlanarRobot(std::shared_ptr<BodyModel> model, std::uint32_t first,
                         std::span<const Mover> movers)
    : first_(first), lever_(physics::lever_of(model->plan)), model_(std::move(model)) {
  std::uint32_t wheels = 0;
  std::size_t vehicle = 0;
  for (const Part& part : plan().parts) {
    if (part.vehicle != vehicle) wheels = 0;
    vehicle = part.vehicle;
    Link link;
    link.vehicle = static_cast<std::uint32_t>(vehicle);
    if (const auto* hitch = std::get_if<HitchJoint>(&part.joint)) {
      Hinge& hinge = hinges_.emplace_back();
      hinge.front = first + link.vehicle - 1;
      hinge.behind = first + link.vehicle;
      hinge.joint = *hitch;
    } else if (const auto* joint = std::get_if<WheelJoint>(&part.joint)) {
      const std::uint32_t wheel = wheels++;
      const std::size_t motor = movers[first + vehicle].wheels()->motor_of(wheel);
      if (motor != Undercarriage::kNoMotor) link.motor = static_cast<std::uint32_t>(motor);
      link.radius = part.shape.radius();
      if (joint->steered) {
        steerings_.push_back({static_cast<std::uint32_t>(links_.size()),
                              wheel,
                              joint->max_steer_rad,
                              joint->steer_rate_rad_s,
                              std::atan2(part.frame.forward.y, part.frame.forward.x),
                              {}});
      }
    }
    if (can_be_set(part.joint)) links_.push_back(link);
  }
  joints_.resize(links_.size());
}

void PlanarRobot::put(const Pose& pose, std::span<Mover> movers) {
  const std::vector<Frame> frames = world::in_line(plan());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Vector3& at = frames[i].origin;
    Mover& mover = movers[first_ + i];
    mover.put(point_of(pose, {at.x, at.y}), pose.heading_rad);
    mover.stop();
  }
  for (Hinge& hinge : hinges_) {
    hinge.yaw_rad = hinge.twist = 0.0;
    hinge.pull = {};
  }
  std::fill(joints_.begin(), joints_.end(), JointSetting());
  for (const Steering& each : steerings_) {
    movers[first_ + links_[each.joint].vehicle].wheels()->point(each.wheel, each.rest_rad);
  }
}

void PlanarRobot::take(const PlanarRobot& other) {
  joints_ = other.joints_;
  steerings_ = other.steerings_;
  for (std::size_t i = 0; i < hinges_.size(); ++i) {
    const auto [front, behind] = std::pair(hinges_[i].front, hinges_[i].behind);
    hinges_[i] = other.hinges_[i];
    hinges_[i].front = front;
    hinges_[i].behind = behind;
  }
}

void PlanarRobot::set_joints(std::span<const JointSetting> settings, std::span<Mover> movers) {
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    if (link.radius == 0.0) {
      Hinge& hinge = hinges_[link.vehicle - 1];
      const double most = hinge.joint.max_yaw_rad;
      hinge.wanted_yaw_rad = std::clamp(settings[i].angle_rad, -most, most);
    } else if (link.motor != kNoMotor) {
      movers[first_ + link.vehicle].wheels()->set_rate(link.motor, settings[i].rate_rad_s);
    }
  }
  for (Steering& each : steerings_) each.wanted = settings[each.joint];
}

double PlanarRobot::rim_speed(std::span<const JointSetting> settings) const {
  double rim = 0.0;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    rim = std::max(rim, links_[i].radius * std::abs(settings[i].rate_rad_s));
  }
  return rim;
}

void PlanarRobot::begin(double step, std::span<Mover> movers) {
  for (const Steering& each : steerings_) steer(each, step, movers);
}

void PlanarRobot::steer(const Steering& steering, double step, std::span<Mover> movers) {
  JointSetting& now = joints_[steering.joint];
  double wanted = steering.wanted.angle_rad;
  const bool all_round = steering.most_rad >= std::numbers::pi;
  if (all_round) {
    wanted = now.angle_rad + wrap_angle(wanted - now.angle_rad);  // the shorter way
  } else {
    wanted = std::clamp(wanted, -steering.most_rad, steering.most_rad);
  }
  const double asked = std::abs(steering.wanted.turn_rad_s);
  const double rate = asked == 0.0 ? steering.rate_rad_s : std::min(asked, steering.rate_rad_s);
  const double angle = approach(now.angle_rad, wanted, step * rate);
  now.turn_rad_s = (angle - now.angle_rad) / step;
  if (angle == now.angle_rad) return;
  now.angle_rad = all_round ? wrap_angle(angle) : angle;
  movers[first_ + links_[steering.joint].vehicle].wheels()->point(
      steering.wheel, steering.rest_rad + now.angle_rad);
}

void PlanarRobot::point_shapes() const {
  for (const Steering& each : steerings_) {
    model_->point(links_[each.joint].vehicle, each.wheel,
                  each.rest_rad + joints_[each.joint].angle_rad);
  }
}

void PlanarRobot::settle(std::span<Mover> movers) {
  for (Hinge& hinge : hinges_) {
    const Mover& front = movers[hinge.front];
    Mover& behind = movers[hinge.behind];
    const double yaw = wrap_angle(behind.heading_rad() - front.heading_rad());
    // Relative to the last angle, so that it does not jump by a full turn.
    const double turned = hinge.yaw_rad + wrap_angle(yaw - hinge.yaw_rad);
    hinge.yaw_rad = std::clamp(turned, -hinge.joint.max_yaw_rad, hinge.joint.max_yaw_rad);
    if (hinge.yaw_rad != turned) behind.turn_to(front.heading_rad() + hinge.yaw_rad);
    const Vector2 back = front.ahead().turn(Vector2{hinge.joint.behind, 0.0});
    const Vector2 arm = behind.ahead().turn(Vector2{hinge.joint.ahead, 0.0});
    const Vector2 &from = front.place(), &at = behind.place();
    behind.shift({from.x - back.x - arm.x - at.x, from.y - back.y - arm.y - at.y});
  }
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    if (link.radius == 0.0) {
      joints_[i].angle_rad = hinges_[link.vehicle - 1].yaw_rad;
    } else if (link.motor != kNoMotor) {
      joints_[i].rate_rad_s = movers[first_ + link.vehicle].wheels()->rate(link.motor);
    }
  }
}

}  // namespace elsie::physics

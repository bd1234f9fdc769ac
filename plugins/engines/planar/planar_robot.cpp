#include "planar_robot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "elsie/world/parts.h"

#include "steering.h"

namespace elsie::physics {
PlanarRobot::PlanarRobot(std::shared_ptr<BodyModel> model, std::uint32_t first)
    : first_(first),
      vehicles_(static_cast<std::uint32_t>(model->movers.size())),
      joints_(model->links.size()),
      model_(std::move(model)) {
  Jointed jointed;
  std::uint32_t wheels = 0, settings = 0;
  std::size_t vehicle = 0;
  for (const Part& part : plan().parts) {
    if (part.vehicle != vehicle) wheels = 0;
    vehicle = part.vehicle;
    if (const auto* hitch = std::get_if<HitchJoint>(&part.joint)) {
      Hinge& hinge = jointed.hinges.emplace_back();
      hinge.behind = first + static_cast<std::uint32_t>(vehicle);
      hinge.front = hinge.behind - 1;
      hinge.joint = *hitch;
      hinge.front_end = {-hitch->behind, 0.0};
      hinge.behind_end = {hitch->ahead, 0.0};
    } else if (const auto* joint = std::get_if<WheelJoint>(&part.joint)) {
      const std::uint32_t wheel = wheels++;
      if (joint->steered) {
        jointed.steerings.push_back({settings,
                                     wheel,
                                     joint->max_steer_rad,
                                     joint->steer_rate_rad_s,
                                     std::atan2(part.frame.forward.y, part.frame.forward.x),
                                     {}});
      }
    }
    if (can_be_set(part.joint)) ++settings;
  }
  if (!jointed.steerings.empty() || !jointed.hinges.empty()) {
    jointed_ = std::make_unique<Jointed>(std::move(jointed));
  }
}

const Hinge& PlanarRobot::hinge(std::size_t segment) const {
  static const std::vector<Hinge> none;
  return (jointed_ ? jointed_->hinges : none).at(segment);
}

void PlanarRobot::put(const Pose& pose, std::span<Mover> movers) {
  const std::vector<Frame> frames = world::in_line(plan());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Vector3& at = frames[i].origin;
    Mover& mover = movers[first_ + i];
    mover.put(point_of(pose, {at.x, at.y}), pose.heading_rad);
    mover.stop();
  }
  for (Hinge& hinge : hinges()) {
    hinge.yaw_rad = hinge.twist = 0.0;
    hinge.pull = {};
  }
  std::fill(joints_.begin(), joints_.end(), JointSetting());
  if (!jointed_) return;
  for (const Steering& each : jointed_->steerings) {
    movers[first_ + links()[each.joint].vehicle].wheels().point(each.wheel, each.rest_rad);
  }
}

void PlanarRobot::take(const PlanarRobot& other) {
  joints_ = other.joints_;
  if (!jointed_) return;
  jointed_->steerings = other.jointed_->steerings;
  for (std::size_t i = 0; i < jointed_->hinges.size(); ++i) {
    Hinge& hinge = jointed_->hinges[i];
    const auto [front, behind] = std::pair(hinge.front, hinge.behind);
    hinge = other.jointed_->hinges[i];
    hinge.front = front;
    hinge.behind = behind;
  }
}

double PlanarRobot::set_joints(std::span<const JointSetting> settings, std::span<Mover> movers) {
  double rim = 0.0;
  const JointSetting* setting = settings.data();
  for (const BodyModel::Link& link : links()) {
    if (link.is_hitch) {
      Hinge& hinge = jointed_->hinges[link.vehicle - 1];
      const double most = hinge.joint.max_yaw_rad;
      hinge.wanted_yaw_rad = std::clamp(setting->angle_rad, -most, most);
    } else if (link.motor != BodyModel::kNoMotor) {
      movers[first_ + link.vehicle].wheels().set_rate(link.motor, setting->rate_rad_s);
    }
    rim = std::max(rim, link.radius * std::abs(setting->rate_rad_s));
    ++setting;
  }
  if (jointed_) {
    for (Steering& each : jointed_->steerings) each.wanted = settings[each.joint];
  }
  return rim;
}

void PlanarRobot::begin(double step, std::span<Mover> movers) {
  if (!jointed_) return;
  for (const Steering& each : jointed_->steerings) steer(each, step, movers);
}

void PlanarRobot::steer(const Steering& steering, double step, std::span<Mover> movers) {
  JointSetting& now = joints_[steering.joint];
  if (!physics::steer(now, steering.wanted, steering.most_rad, steering.rate_rad_s, step)) return;
  movers[first_ + links()[steering.joint].vehicle].wheels().point(
      steering.wheel, steering.rest_rad + now.angle_rad);
}

void PlanarRobot::point_wheels() const {
  for (const Steering& each : jointed_->steerings) {
    model_->point(links()[each.joint].vehicle, each.wheel,
                  each.rest_rad + joints_[each.joint].angle_rad);
  }
}

/// Puts a pulled vehicle back to its joint.
void PlanarRobot::straighten(Hinge& hinge, std::span<Mover> movers) const {
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

void PlanarRobot::settle(std::span<Mover> movers) {
  for (Hinge& hinge : hinges()) straighten(hinge, movers);
  JointSetting* joint = joints_.data();
  for (const BodyModel::Link& link : links()) {
    if (link.is_hitch) {
      joint->angle_rad = jointed_->hinges[link.vehicle - 1].yaw_rad;
    } else if (link.motor != BodyModel::kNoMotor) {
      joint->rate_rad_s = movers[first_ + link.vehicle].wheels().rate(link.motor);
    }
    ++joint;
  }
}

}  // namespace elsie::physics

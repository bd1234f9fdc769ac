#include "steering.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace drives {

namespace {

constexpr double kAlmostAcross = 0.5 * std::numbers::pi - 1e-3;

}  // namespace

void SteeredDrive::build(const elsie::Chassis& chassis, elsie::BodyPlan& plan) {
  Layout built = layout(0.5 * wheelbase_or_default(wheelbase, chassis), chassis.half_axle);
  wheels_ = std::move(built.wheels);
  pivot_ = built.pivot;
  max_steer_rad_ = elsie::radians(max_steer_deg);
  rate_rad_s_ = elsie::radians(steer_rate_deg_s);
  radius_ = chassis.wheel_radius;
  tightest_ = lever_ = 0.0;
  for (const Wheel& each : wheels_) {
    add(each, chassis, plan);
  }
  require_apart(plan, sweep(chassis));
}

void SteeredDrive::add(const Wheel& each, const elsie::Chassis& chassis, elsie::BodyPlan& plan) {
  WheelJoint joint{.torque = each.driven ? chassis.wheel_torque : 0.0};
  if (each.steered) {
    const double away = std::abs(each.x - pivot_), tangent = std::tan(max_steer_rad_);
    require(away > 0.0,
            "its steered wheel '" + each.name + "' stands on the line that the body turns about");
    const double own = tangent / (away + std::abs(each.y) * tangent);
    tightest_ = lever_ > 0.0 ? std::min(tightest_, own) : own;
    lever_ = std::max(lever_, away);
    joint.steered = true;
    joint.max_steer_rad = max_steer_rad_;
    joint.steer_rate_rad_s = rate_rad_s_;
  }
  plan.parts.push_back(wheel(each.name, chassis, each.x, each.y, joint));
}

elsie::Motion SteeredDrive::command(const elsie::Motion& asked, const elsie::DriveState& now,
                                    std::span<elsie::JointSetting> joints) {
  double v = asked.forward;
  double k = curvature(now.joints);
  if (std::abs(asked.turn) > tightest_ * std::abs(v)) {
    // The foot of the perpendicular on the line of the tightest turn.
    const double square = tightest_ * lever_ * tightest_ * lever_;
    const double speed =
        (std::abs(v) + tightest_ * lever_ * lever_ * std::abs(asked.turn)) / (1.0 + square);
    v = std::copysign(speed, v);
    k = std::copysign(tightest_, asked.turn * v);
  } else if (v != 0.0) {
    k = asked.turn / v;
  }
  k = within_reach(k, now);
  for (const Wheel& each : wheels_) {
    v = std::copysign(std::min(std::abs(v), now.max_speed / std::abs(pace(each, k))), v);
  }
  std::size_t at = 0;
  for (const Wheel& each : wheels_) {
    if (!each.driven && !each.steered) continue;
    joints[at].rate_rad_s = each.driven ? v * pace(each, k) / radius_ : 0.0;
    joints[at].angle_rad = each.steered ? angle(each, k) : 0.0;
    joints[at].turn_rad_s = 0.0;
    ++at;
  }
  return motion(v, k);
}

elsie::Motion SteeredDrive::odometry(std::span<const elsie::JointSetting> joints) const {
  const double k = curvature(joints);
  double sum = 0.0, count = 0.0;
  std::size_t at = 0;
  for (const Wheel& each : wheels_) {
    if (!each.driven && !each.steered) continue;
    if (each.driven) {
      sum += radius_ * joints[at].rate_rad_s / pace(each, k);
      count += 1.0;
    }
    ++at;
  }
  return motion(count > 0.0 ? sum / count : 0.0, k);
}

double SteeredDrive::angle(const Wheel& wheel, double k) const {
  return std::atan2(k * (wheel.x - pivot_), 1.0 - k * wheel.y);
}

double SteeredDrive::pace(const Wheel& wheel, double k) const {
  return std::hypot(wheel.steered ? k * (wheel.x - pivot_) : 0.0, 1.0 - k * wheel.y);
}

double SteeredDrive::curvature_of(const Wheel& wheel, double angle) const {
  const double tangent = std::tan(std::clamp(angle, -kAlmostAcross, kAlmostAcross));
  return tangent / (wheel.x - pivot_ + wheel.y * tangent);
}

double SteeredDrive::curvature(std::span<const elsie::JointSetting> joints) const {
  double sum = 0.0, count = 0.0;
  for_each_steered(joints, [&](const Wheel& wheel, double at) {
    sum += curvature_of(wheel, at);
    count += 1.0;
  });
  return count > 0.0 ? std::clamp(sum / count, -tightest_, tightest_) : 0.0;
}

double SteeredDrive::within_reach(double wanted, const elsie::DriveState& now) const {
  const double most = rate_rad_s_ * now.period_s;
  double low = -tightest_, high = tightest_;
  for_each_steered(now.joints, [&](const Wheel& wheel, double at) {
    // A wheel stays between its angles in the tightest turns; other angles belong to no turn.
    const auto [least, greatest] = std::minmax({angle(wheel, -tightest_), angle(wheel, tightest_)});
    const double a = curvature_of(wheel, std::clamp(at - most, least, greatest));
    const double b = curvature_of(wheel, std::clamp(at + most, least, greatest));
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  });
  // If the limits of the wheels contradict each other: the middle between them.
  return low > high ? std::clamp(0.5 * (low + high), -tightest_, tightest_)
                    : std::clamp(wanted, low, high);
}

}  // namespace drives

// Drives with steered wheels that share one centre of rotation.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "undercarriage.h"

namespace drives {

/// The law of Ackermann for any number of wheels: the axles of all wheels meet in one point. It
/// lies on a line across the body at `pivot`, ahead of its middle, at the distance 1 / k to the
/// left of the body's axis. The point where the axis crosses that line moves straight ahead, at v,
/// and the body turns at w = k v. A wheel at (x, y) then has
///     direction  atan2(k (x - pivot), 1 - k y)
///     rim speed  v hypot(k (x - pivot), 1 - k y).
class Steering {
 public:
  struct Wheel {
    std::string name;
    double x = 0.0, y = 0.0;
    bool driven = false, steered = false;
  };
  struct Limits {
    double max_steer_rad = 0.0;  // of every steered wheel, below a right angle
    double rate_rad_s = 0.0;
  };

  /// Adds the wheels to the body, and finds the tightest turn.
  void build(std::vector<Wheel> wheels, double pivot, const Limits& limits, const Chassis& chassis,
             BodyPlan& plan) {
    wheels_ = std::move(wheels);
    pivot_ = pivot;
    limits_ = limits;
    radius_ = chassis.wheel_radius;
    tightest_ = lever_ = 0.0;
    bool steers = false;
    for (const Wheel& each : wheels_) {
      WheelJoint joint{.torque = each.driven ? chassis.wheel_torque : 0.0};
      if (each.steered) {
        const double away = std::abs(each.x - pivot), tangent = std::tan(limits.max_steer_rad);
        require(away > 0.0, "its steered wheel '" + each.name +
                                "' stands on the line that the body turns about");
        const double own = tangent / (away + std::abs(each.y) * tangent);
        tightest_ = steers ? std::min(tightest_, own) : own;
        lever_ = std::max(lever_, away);
        steers = true;
        joint.steered = true;
        joint.max_steer_rad = limits.max_steer_rad;
        joint.steer_rate_rad_s = limits.rate_rad_s;
      }
      plan.parts.push_back(wheel(each.name, chassis, each.x, each.y, joint));
    }
  }

  /// The curvature of the tightest turn, 1/m.
  double tightest() const { return tightest_; }

  /// Sets the wheels for the motion nearest to `asked` that the steering can reach until the next
  /// command, and returns it. The lever of the steering makes turns comparable with speeds.
  elsie::Motion command(const elsie::Motion& asked, const elsie::DriveState& now,
                        std::span<elsie::JointSetting> joints) const {
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

  elsie::Motion odometry(std::span<const elsie::JointSetting> joints) const {
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

 private:
  /// The motion of the body's middle, which is not on the pivot's line.
  elsie::Motion motion(double v, double k) const { return {v, -k * v * pivot_, k * v}; }
  double angle(const Wheel& wheel, double k) const {
    return std::atan2(k * (wheel.x - pivot_), 1.0 - k * wheel.y);
  }
  /// The speed of the rim divided by the speed of the body.
  double pace(const Wheel& wheel, double k) const {
    return std::hypot(wheel.steered ? k * (wheel.x - pivot_) : 0.0, 1.0 - k * wheel.y);
  }
  /// The curvature of the turn in which the wheel has this angle.
  double curvature_of(const Wheel& wheel, double angle) const {
    const double tangent = std::tan(std::clamp(angle, -kAlmostAcross, kAlmostAcross));
    return tangent / (wheel.x - pivot_ + wheel.y * tangent);
  }

  template <class See>
  void for_each_steered(std::span<const elsie::JointSetting> joints, See see) const {
    std::size_t at = 0;
    for (const Wheel& each : wheels_) {
      if (!each.driven && !each.steered) continue;
      if (each.steered && at < joints.size()) see(each, joints[at].angle_rad);
      ++at;
    }
  }
  /// The mean curvature of the steered wheels.
  double curvature(std::span<const elsie::JointSetting> joints) const {
    double sum = 0.0, count = 0.0;
    for_each_steered(joints, [&](const Wheel& wheel, double at) {
      sum += curvature_of(wheel, at);
      count += 1.0;
    });
    return count > 0.0 ? std::clamp(sum / count, -tightest_, tightest_) : 0.0;
  }
  /// Limits the curvature so that no steered wheel turns further than its steering can in a period.
  double within_reach(double wanted, const elsie::DriveState& now) const {
    const double most = limits_.rate_rad_s * now.period_s;
    double low = -tightest_, high = tightest_;
    for_each_steered(now.joints, [&](const Wheel& wheel, double at) {
      // A wheel stays between its angles in the tightest turns; other angles belong to no turn.
      const auto [least, greatest] =
          std::minmax({angle(wheel, -tightest_), angle(wheel, tightest_)});
      const double a = curvature_of(wheel, std::clamp(at - most, least, greatest));
      const double b = curvature_of(wheel, std::clamp(at + most, least, greatest));
      low = std::max(low, std::min(a, b));
      high = std::min(high, std::max(a, b));
    });
    // If the limits of the wheels contradict each other: the middle between them.
    return low > high ? std::clamp(0.5 * (low + high), -tightest_, tightest_)
                      : std::clamp(wanted, low, high);
  }

  static constexpr double kAlmostAcross = 0.5 * std::numbers::pi - 1e-3;

  std::vector<Wheel> wheels_;
  double pivot_ = 0.0;
  Limits limits_;
  double radius_ = 0.02;
  double tightest_ = 0.0;  // 1 / m
  double lever_ = 0.0;     // m, of the steered wheel that is furthest from the pivot
};

}  // namespace drives

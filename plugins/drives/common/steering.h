// Drives with steered wheels that share one centre of rotation.
#pragma once

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
class SteeredDrive : public elsie::Drive {
 public:
  double wheelbase = 0.0;
  double max_steer_deg = 40.0;
  double steer_rate_deg_s = 180.0;

  void build(const elsie::Chassis& chassis, elsie::BodyPlan& plan) override;
  /// Sets the wheels for the motion nearest to `asked` that the steering can reach until the next
  /// command, and returns it. The lever of the steering makes turns comparable with speeds.
  elsie::Motion command(const elsie::Motion& asked, const elsie::DriveState& now,
                        std::span<elsie::JointSetting> joints) override;
  elsie::Motion odometry(std::span<const elsie::JointSetting> joints) const override;

 protected:
  struct Wheel {
    std::string name;
    double x = 0.0, y = 0.0;
    bool driven = false, steered = false;
  };
  struct Layout {
    std::vector<Wheel> wheels;
    double pivot = 0.0;  // m
  };

 private:
  /// The wheels, their axles at x and -x, and the wheels of an axle at y and -y (m).
  virtual Layout layout(double x, double y) const = 0;

  void add(const Wheel& wheel, const elsie::Chassis& chassis, elsie::BodyPlan& plan);
  /// The motion of the body's middle, which is not on the pivot's line.
  elsie::Motion motion(double v, double k) const { return {v, -k * v * pivot_, k * v}; }
  double angle(const Wheel& wheel, double k) const;
  /// The speed of the rim divided by the speed of the body.
  double pace(const Wheel& wheel, double k) const;
  /// The curvature of the turn in which the wheel has this angle.
  double curvature_of(const Wheel& wheel, double angle) const;
  /// The mean curvature of the steered wheels.
  double curvature(std::span<const elsie::JointSetting> joints) const;
  /// Limits the curvature so that no steered wheel turns further than its steering can in a period.
  double within_reach(double wanted, const elsie::DriveState& now) const;

  template <class See>
  void for_each_steered(std::span<const elsie::JointSetting> joints, See see) const {
    std::size_t at = 0;
    for (const Wheel& each : wheels_) {
      if (!each.driven && !each.steered) continue;
      if (each.steered && at < joints.size()) see(each, joints[at].angle_rad);
      ++at;
    }
  }

  std::vector<Wheel> wheels_;
  double pivot_ = 0.0;
  double max_steer_rad_ = 0.0;  // of every steered wheel, below a right angle
  double rate_rad_s_ = 0.0;
  double radius_ = 0.02;
  double tightest_ = 0.0;  // curvature of the tightest turn, 1 / m
  double lever_ = 0.0;     // m, of the steered wheel that is furthest from the pivot
};

// The items of the declaration of such a drive.
#define STEERED_DRIVE_PARAMETERS                                                              \
  elsie::parameter("wheelbase", &drives::SteeredDrive::wheelbase,                             \
                   {.unit = "m",                                                              \
                    .min = 0,                                                                 \
                    .max = 10,                                                                \
                    .meaning = "between front and rear axle; 0: the length of the chassis"}), \
      elsie::parameter("max_steer_deg", &drives::SteeredDrive::max_steer_deg,                 \
                       {.unit = "deg",                                                        \
                        .min = 1,                                                             \
                        .max = 80,                                                            \
                        .meaning = "how far a wheel is steered to either side"}),             \
      elsie::parameter(                                                                       \
          "steer_rate_deg_s", &drives::SteeredDrive::steer_rate_deg_s,                        \
          {.unit = "deg/s", .min = 1, .max = 10000, .meaning = "how fast the steering turns"})

}  // namespace drives

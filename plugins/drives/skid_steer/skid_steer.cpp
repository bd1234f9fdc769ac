// Four driven wheels that cannot be steered. The wheels of a side turn alike, and in a turn all of
// them slide sideways. If the track is wider than the wheelbase, the tyres hold along their
// directions while they slide across, and the law is that of a differential drive:
//     v = r (wl + wr) / 2,  w = r (wr - wl) / (2 b)
// with half the track b. Longer vehicles need more force to turn than their tyres have.
#include <array>
#include <string>

#include "undercarriage.h"

namespace {

class SkidSteer final : public elsie::Drive {
 public:
  double wheelbase = 0.0;

  void build(const elsie::Chassis& chassis, elsie::BodyPlan& plan) override {
    const double base =
        wheelbase > 0.0 ? wheelbase : std::max(chassis.half_axle, 2.5 * chassis.wheel_radius);
    drives::require(base < 2.0 * chassis.half_axle,
                    "its wheelbase is " + std::to_string(base) + " m and its track " +
                        std::to_string(2.0 * chassis.half_axle) +
                        " m; it turns only with a wheelbase that is shorter than its track");
    pair_ = wheels(chassis);
    const elsie::WheelJoint joint{.torque = chassis.wheel_torque};
    for (const bool front : {true, false}) {
      for (const bool left : {true, false}) {
        plan.parts.push_back(drives::wheel(
            std::string(front ? "front" : "rear") + (left ? "_left_wheel" : "_right_wheel"),
            chassis, (front ? 0.5 : -0.5) * base, (left ? 1.0 : -1.0) * chassis.half_axle, joint));
      }
    }
  }

  elsie::Motion command(const elsie::Motion& asked, const elsie::DriveState& now,
                        std::span<elsie::JointSetting> joints) override {
    elsie::WheelRates rates = pair_.wheel_rates(asked);
    rates =
        drives::slowed(std::array{rates.left, rates.right}, now.max_speed / pair_.radius) * rates;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      joints[i] = {i % 2 == 0 ? rates.left : rates.right};
    }
    return pair_.motion(rates);
  }
  elsie::Motion odometry(std::span<const elsie::JointSetting> joints) const override {
    return pair_.motion({0.5 * (joints[0].rate_rad_s + joints[2].rate_rad_s),
                         0.5 * (joints[1].rate_rad_s + joints[3].rate_rad_s)});
  }

 private:
  elsie::WheelPair pair_;
};

ELSIE_DRIVE(
    SkidSteer, "skid_steer", "Four driven wheels; those of a side turn alike",
    elsie::parameter(
        "wheelbase", &SkidSteer::wheelbase,
        {.unit = "m",
         .min = 0,
         .max = 10,
         .meaning = "between front and rear axle, less than the track; 0: half the track"}));

}  // namespace

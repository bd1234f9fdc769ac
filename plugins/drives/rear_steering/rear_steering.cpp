// Two driven wheels in front, two steered ones behind, as on a fork-lift truck: the law of a car
// that drives backwards. With the wheelbase L and the steering angle f of a wheel in the middle, to
// the left of the body's axis when positive, the front axle moves at v, and
//     w = -v tan(f) / L.
#include "steering.h"

namespace {

class RearSteering final : public elsie::Drive {
 public:
  double wheelbase = 0.0;
  double max_steer_deg = 40.0;
  double steer_rate_deg_s = 180.0;

  void build(const elsie::Chassis& chassis, elsie::BodyPlan& plan) override {
    const double x = 0.5 * drives::wheelbase_or_default(wheelbase, chassis);
    const double y = chassis.half_axle;
    steering_.build({{"front_left_wheel", x, y, true, false},
                     {"front_right_wheel", x, -y, true, false},
                     {"rear_left_wheel", -x, y, false, true},
                     {"rear_right_wheel", -x, -y, false, true}},
                    x, {elsie::radians(max_steer_deg), elsie::radians(steer_rate_deg_s)}, chassis,
                    plan);
    drives::require_apart(plan, drives::sweep(chassis));
  }

  elsie::Motion command(const elsie::Motion& asked, const elsie::DriveState& now,
                        std::span<elsie::JointSetting> joints) override {
    return steering_.command(asked, now, joints);
  }
  elsie::Motion odometry(std::span<const elsie::JointSetting> joints) const override {
    return steering_.odometry(joints);
  }

 private:
  drives::Steering steering_;
};

ELSIE_DRIVE(
    RearSteering, "rear_steering", "Two driven wheels in front and two steered ones behind",
    elsie::parameter("wheelbase", &RearSteering::wheelbase,
                     {.unit = "m",
                      .min = 0,
                      .max = 10,
                      .meaning = "between front and rear axle; 0: the length of the chassis"}),
    elsie::parameter("max_steer_deg", &RearSteering::max_steer_deg,
                     {.unit = "deg",
                      .min = 1,
                      .max = 80,
                      .meaning = "how far a wheel is steered to either side"}),
    elsie::parameter(
        "steer_rate_deg_s", &RearSteering::steer_rate_deg_s,
        {.unit = "deg/s", .min = 1, .max = 10000, .meaning = "how fast the steering turns"}));

}  // namespace

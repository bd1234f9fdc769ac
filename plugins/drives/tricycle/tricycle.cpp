// One wheel in front that drives and steers, two behind that roll. With the wheelbase l, the rim
// speed u of the front wheel and its angle f,
//     v = u cos(f),  w = u sin(f) / l,
// where v is the speed of the middle between the rear wheels.
#include "steering.h"

namespace {

class Tricycle final : public elsie::Drive {
 public:
  double wheelbase = 0.0;
  double max_steer_deg = 70.0;
  double steer_rate_deg_s = 180.0;

  void build(const elsie::Chassis& chassis, elsie::BodyPlan& plan) override {
    const double x = 0.5 * drives::wheelbase_or_default(wheelbase, chassis);
    const double y = chassis.half_axle;
    steering_.build({{"front_wheel", x, 0.0, true, true},
                     {"rear_left_wheel", -x, y, false, false},
                     {"rear_right_wheel", -x, -y, false, false}},
                    -x, {elsie::radians(max_steer_deg), elsie::radians(steer_rate_deg_s)}, chassis,
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
    Tricycle, "tricycle", "One wheel in front that drives and steers, two behind that roll",
    elsie::parameter("wheelbase", &Tricycle::wheelbase,
                     {.unit = "m",
                      .min = 0,
                      .max = 10,
                      .meaning = "between front and rear axle; 0: the length of the chassis"}),
    elsie::parameter("max_steer_deg", &Tricycle::max_steer_deg,
                     {.unit = "deg",
                      .min = 1,
                      .max = 80,
                      .meaning = "how far a wheel is steered to either side"}),
    elsie::parameter(
        "steer_rate_deg_s", &Tricycle::steer_rate_deg_s,
        {.unit = "deg/s", .min = 1, .max = 10000, .meaning = "how fast the steering turns"}));

}  // namespace

// Four driven wheels, all of them steered: the rear ones by the angle of the front ones, to the
// other side. With the wheelbase L and the angles f and -f of wheels in the middle of their axles,
// the middle of the body moves at v, and
//     w = 2 v tan(f) / L:
// curves are half as wide as those of a car with the same limits.
#include "steering.h"

namespace {

class FrontRearSteering final : public elsie::Drive {
 public:
  double wheelbase = 0.0;
  double max_steer_deg = 40.0;
  double steer_rate_deg_s = 180.0;

  void build(const elsie::Chassis& chassis, elsie::BodyPlan& plan) override {
    const double x = 0.5 * drives::wheelbase_or_default(wheelbase, chassis);
    const double y = chassis.half_axle;
    steering_.build({{"front_left_wheel", x, y, true, true},
                     {"front_right_wheel", x, -y, true, true},
                     {"rear_left_wheel", -x, y, true, true},
                     {"rear_right_wheel", -x, -y, true, true}},
                    0.0, {elsie::radians(max_steer_deg), elsie::radians(steer_rate_deg_s)}, chassis,
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
    FrontRearSteering, "front_rear_steering",
    "Four driven wheels, the front and the rear ones steered",
    elsie::parameter("wheelbase", &FrontRearSteering::wheelbase,
                     {.unit = "m",
                      .min = 0,
                      .max = 10,
                      .meaning = "between front and rear axle; 0: the length of the chassis"}),
    elsie::parameter("max_steer_deg", &FrontRearSteering::max_steer_deg,
                     {.unit = "deg",
                      .min = 1,
                      .max = 80,
                      .meaning = "how far a wheel is steered to either side"}),
    elsie::parameter(
        "steer_rate_deg_s", &FrontRearSteering::steer_rate_deg_s,
        {.unit = "deg/s", .min = 1, .max = 10000, .meaning = "how fast the steering turns"}));

}  // namespace

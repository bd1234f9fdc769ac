// A car: two driven wheels behind, two steered ones in front, whose axles meet in one point with
// that of the rear wheels (Ackermann, 1818). With the wheelbase L and the steering angle f of a
// wheel in the middle, the rear axle moves at v, and
//     w = v tan(f) / L.
// The rear wheels share the speed as a differential gear would.
#include "steering.h"

namespace {

class Car final : public elsie::Drive {
 public:
  double wheelbase = 0.0;
  double max_steer_deg = 40.0;
  double steer_rate_deg_s = 180.0;

  void build(const elsie::Chassis& chassis, elsie::BodyPlan& plan) override {
    const double x = 0.5 * drives::wheelbase_or_default(wheelbase, chassis);
    const double y = chassis.half_axle;
    steering_.build({{"front_left_wheel", x, y, false, true},
                     {"front_right_wheel", x, -y, false, true},
                     {"rear_left_wheel", -x, y, true, false},
                     {"rear_right_wheel", -x, -y, true, false}},
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
    Car, "car", "Two driven wheels behind and two steered ones in front",
    elsie::parameter("wheelbase", &Car::wheelbase,
                     {.unit = "m",
                      .min = 0,
                      .max = 10,
                      .meaning = "between front and rear axle; 0: the length of the chassis"}),
    elsie::parameter("max_steer_deg", &Car::max_steer_deg,
                     {.unit = "deg",
                      .min = 1,
                      .max = 80,
                      .meaning = "how far a wheel is steered to either side"}),
    elsie::parameter(
        "steer_rate_deg_s", &Car::steer_rate_deg_s,
        {.unit = "deg/s", .min = 1, .max = 10000, .meaning = "how fast the steering turns"}));

}  // namespace

// Four wheels with rollers at 45 degrees on their rims (Ilon, US patent 3876255, 1975). Seen from
// above, the rollers that touch the floor lie on the sides of a diamond, so that every turn of the
// body turns the wheels:
//     r w1 = vx - vy - (a + b) w    front left
//     r w2 = vx + vy + (a + b) w    front right
//     r w3 = vx + vy - (a + b) w    rear left
//     r w4 = vx - vy + (a + b) w    rear right
// with half the wheelbase a and half the track b.
#include <numbers>
#include <string>

#include "rolling.h"

namespace {

class Mecanum final : public drives::RollingDrive {
 public:
  double wheelbase = 0.0;

 private:
  void add_wheels(const elsie::Chassis& chassis, elsie::BodyPlan& plan) const override {
    const double x = 0.5 * drives::wheelbase_or_default(wheelbase, chassis);
    for (const bool front : {true, false}) {
      for (const bool left : {true, false}) {
        const double rollers = (front == left ? -0.25 : 0.25) * std::numbers::pi;
        const elsie::WheelJoint joint{.torque = chassis.wheel_torque, .rollers_rad = rollers};
        plan.parts.push_back(drives::wheel(
            std::string(front ? "front" : "rear") + (left ? "_left_wheel" : "_right_wheel"),
            chassis, front ? x : -x, (left ? 1.0 : -1.0) * chassis.half_axle, joint));
      }
    }
  }
};

ELSIE_DRIVE(
    Mecanum, "mecanum", "Four wheels with rollers at 45 degrees: moves in every direction",
    elsie::parameter("wheelbase", &Mecanum::wheelbase,
                     {.unit = "m",
                      .min = 0,
                      .max = 10,
                      .meaning = "between front and rear axle; 0: the length of the chassis"}));

}  // namespace

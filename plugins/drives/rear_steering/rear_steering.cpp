// Two driven wheels in front, two steered ones behind, as on a fork-lift truck: the law of a car
// that drives backwards. With the wheelbase L and the steering angle f of a wheel in the middle, to
// the left of the body's axis when positive, the front axle moves at v, and
//     w = -v tan(f) / L.
#include "steering.h"

namespace {

class RearSteering final : public drives::SteeredDrive {
 private:
  Layout layout(double x, double y) const override {
    return {{{"front_left_wheel", x, y, true, false},
             {"front_right_wheel", x, -y, true, false},
             {"rear_left_wheel", -x, y, false, true},
             {"rear_right_wheel", -x, -y, false, true}},
            x};
  }
};

ELSIE_DRIVE(RearSteering, "rear_steering", "Two driven wheels in front and two steered ones behind",
            STEERED_DRIVE_PARAMETERS);

}  // namespace

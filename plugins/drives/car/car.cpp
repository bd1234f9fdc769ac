// A car: two driven wheels behind, two steered ones in front, whose axles meet in one point with
// that of the rear wheels (Ackermann, 1818). With the wheelbase L and the steering angle f of a
// wheel in the middle, the rear axle moves at v, and
//     w = v tan(f) / L.
// The rear wheels share the speed as a differential gear would.
#include "steering.h"

namespace {

class Car final : public drives::SteeredDrive {
 private:
  Layout layout(double x, double y) const override {
    return {{{"front_left_wheel", x, y, false, true},
             {"front_right_wheel", x, -y, false, true},
             {"rear_left_wheel", -x, y, true, false},
             {"rear_right_wheel", -x, -y, true, false}},
            -x};
  }
};

ELSIE_DRIVE(Car, "car", "Two driven wheels behind and two steered ones in front",
            STEERED_DRIVE_PARAMETERS);

}  // namespace

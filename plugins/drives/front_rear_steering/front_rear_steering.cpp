// Four driven wheels, all of them steered: the rear ones by the angle of the front ones, to the
// other side. With the wheelbase L and the angles f and -f of wheels in the middle of their axles,
// the middle of the body moves at v, and
//     w = 2 v tan(f) / L:
// curves are half as wide as those of a car with the same limits.
#include "steering.h"

namespace {

class FrontRearSteering final : public drives::SteeredDrive {
 private:
  Layout layout(double x, double y) const override {
    return {{{"front_left_wheel", x, y, true, true},
             {"front_right_wheel", x, -y, true, true},
             {"rear_left_wheel", -x, y, true, true},
             {"rear_right_wheel", -x, -y, true, true}},
            0.0};
  }
};

ELSIE_DRIVE(FrontRearSteering, "front_rear_steering",
            "Four driven wheels, the front and the rear ones steered", STEERED_DRIVE_PARAMETERS);

}  // namespace

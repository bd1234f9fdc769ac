// One wheel in front that drives and steers, two behind that roll. With the wheelbase l, the rim
// speed u of the front wheel and its angle f,
//     v = u cos(f),  w = u sin(f) / l,
// where v is the speed of the middle between the rear wheels.
#include "steering.h"

namespace {

class Tricycle final : public drives::SteeredDrive {
 public:
  Tricycle() { max_steer_deg = 70.0; }

 private:
  Layout layout(double x, double y) const override {
    return {{{"front_wheel", x, 0.0, true, true},
             {"rear_left_wheel", -x, y, false, false},
             {"rear_right_wheel", -x, -y, false, false}},
            -x};
  }
};

ELSIE_DRIVE(Tricycle, "tricycle", "One wheel in front that drives and steers, two behind that roll",
            STEERED_DRIVE_PARAMETERS);

}  // namespace

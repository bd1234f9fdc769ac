// Turns left, away from obstacles on the right, by fuzzy controllers for each wheel, averaged over
// the beams.
#include "beam_steering.h"

namespace {

class TurnLeft final : public BeamSteering {
 public:
  TurnLeft()
      : BeamSteering("fuzzy_models/turn_left_left.fcl", "fuzzy_models/turn_left_right.fcl", false) {
  }

 private:
  bool concerns(double azimuth_rad) const override { return azimuth_rad < 0.0; }
};

}  // namespace

ELSIE_BEHAVIOR(
    TurnLeft, "turn_left",
    "Turns left, away from obstacles on the right, and ignores those on the left",
    elsie::parameter(
        "left_model", &TurnLeft::left_model,
        {.meaning = "fuzzy model (FCL) of the left wheel: inputs range and azimuth, output speed"}),
    elsie::parameter("right_model", &TurnLeft::right_model,
                     {.meaning = "fuzzy model (FCL) of the right wheel"}),
    elsie::parameter("left_block", &TurnLeft::left_block,
                     {.meaning = "function block of left_model, if the file has several"}),
    elsie::parameter("right_block", &TurnLeft::right_block,
                     {.meaning = "function block of right_model, if the file has several"}));

// Turns right, away from obstacles on the left: the mirror image of turn_left.
#include "beam_steering.h"

namespace {

class TurnRight final : public BeamSteering {
 public:
  TurnRight()
      : BeamSteering("fuzzy_models/turn_right_left.fcl", "fuzzy_models/turn_right_right.fcl",
                     false) {}

 private:
  bool concerns(double azimuth_rad) const override { return azimuth_rad > 0.0; }
};

}  // namespace

ELSIE_BEHAVIOR(
    TurnRight, "turn_right",
    "Turns right, away from obstacles on the left, and ignores those on the right",
    elsie::parameter(
        "left_model", &TurnRight::left_model,
        {.meaning = "fuzzy model (FCL) of the left wheel: inputs range and azimuth, output speed"}),
    elsie::parameter("right_model", &TurnRight::right_model,
                     {.meaning = "fuzzy model (FCL) of the right wheel"}),
    elsie::parameter("left_block", &TurnRight::left_block,
                     {.meaning = "function block of left_model, if the file has several"}),
    elsie::parameter("right_block", &TurnRight::right_block,
                     {.meaning = "function block of right_model, if the file has several"}));

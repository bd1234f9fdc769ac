// Slows down near obstacles and turns away from the nearer side. Each beam has a pair of fuzzy
// controllers, one for each wheel; the outputs for the nearest beam count twice, and the sum is
// divided by the number of beams plus one.
#include "beam_steering.h"

namespace {

class AvoidObstacle final : public BeamSteering {
 public:
  AvoidObstacle()
      : BeamSteering("fuzzy_models/avoid_obstacle_left.fcl",
                     "fuzzy_models/avoid_obstacle_right.fcl", true) {}
};

}  // namespace

ELSIE_BEHAVIOR(
    AvoidObstacle, "avoid_obstacle",
    "Slows down near obstacles and turns away from the nearer side",
    elsie::parameter(
        "left_model", &AvoidObstacle::left_model,
        {.meaning = "fuzzy model (FCL) of the left wheel: inputs range and azimuth, output speed"}),
    elsie::parameter("right_model", &AvoidObstacle::right_model,
                     {.meaning = "fuzzy model (FCL) of the right wheel"}),
    elsie::parameter("left_block", &AvoidObstacle::left_block,
                     {.meaning = "function block of left_model, if the file has several"}),
    elsie::parameter("right_block", &AvoidObstacle::right_block,
                     {.meaning = "function block of right_model, if the file has several"}));

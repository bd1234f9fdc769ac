// Drives to a place and stops there.
#include "going.h"
#include "place_goal.h"

namespace {

class GoToPoint final : public PlaceGoal, public Going {
 protected:
  elsie::Response approach(const elsie::Perception&, double away_m, double off_rad) override {
    return steer(off_rad, away_m, speed, gain, slow_down);
  }
};

}  // namespace

ELSIE_BEHAVIOR(
    GoToPoint, "go_to_point", "Drives to a place and stops there; not active once it is there",
    elsie::parameter("x", &GoToPoint::x, {.unit = "m", .meaning = "the place, east"}),
    elsie::parameter("y", &GoToPoint::y, {.unit = "m", .meaning = "the place, north"}),
    speed_of_going(), gain_of_going(), slow_down_of_going(),
    elsie::parameter("tolerance", &GoToPoint::tolerance,
                     {.unit = "m", .above = 0, .meaning = "nearer than this, it has arrived"}),
    elsie::raises("arrived", "the robot has come within the tolerance of the place"));

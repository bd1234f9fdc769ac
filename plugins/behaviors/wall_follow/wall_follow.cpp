// Follows a wall on one side at a distance, around inner and outer corners: the law of
// wall_pursuit.h, with parameters and events.
#include <string>

#include "wall_pursuit.h"

namespace {

class WallFollow final : public elsie::Behavior, public elsie::Remembers {
 public:
  std::string side = "right";
  double distance = 0.3;
  double reach = 0.75;
  double front_angle = 30.0;
  double speed = 0.2;
  double lookahead = 0.3;
  double turn_rate = 1.5;

  void configured() override {
    pursuit_.set({side == "left", distance, reach, elsie::radians(front_angle), speed, lookahead,
                  turn_rate});
  }
  void equipped(const elsie::Perception& example) override { pursuit_.check(example); }
  void reset(elsie::Random&) override { pursuit_.reset(); }
  void remember(elsie::Memory& memory) override { pursuit_.remember(memory); }

  elsie::Response respond(const elsie::Perception& now) override {
    const bool was_searching = pursuit_.look(now) == WallPursuit::State::searching;
    elsie::Response response = pursuit_.act();
    const bool searches = pursuit_.state() == WallPursuit::State::searching;
    if (was_searching && !searches) {
      response.events.push_back({"wall_found"});
    } else if (!was_searching && searches) {
      response.events.push_back({"wall_lost"});
    }
    return response;
  }

 private:
  WallPursuit pursuit_;
};

}  // namespace

ELSIE_BEHAVIOR(
    WallFollow, "wall_follow",
    "Follows a wall on one side at a distance, round inner and outer corners",
    elsie::parameter("side", &WallFollow::side,
                     {.choices = {"left", "right"}, .meaning = "where the wall is"}),
    elsie::parameter(
        "distance", &WallFollow::distance,
        {.unit = "m",
         .above = 0,
         .meaning =
             "from the robot's middle to the wall; it turns away from anything nearer ahead"}),
    elsie::parameter("reach", &WallFollow::reach,
                     {.unit = "m",
                      .above = 0,
                      .meaning = "beyond this distance from the robot's middle, there is no wall"}),
    elsie::parameter("front_angle", &WallFollow::front_angle,
                     {.unit = "deg",
                      .min = 0,
                      .max = 60,
                      .meaning = "rays look ahead up to this azimuth to either side, in "
                                 "degrees, and to the side beyond it, up to 150"}),
    elsie::parameter("speed", &WallFollow::speed,
                     {.unit = "m/s", .above = 0, .max = 50, .meaning = "along the wall"}),
    elsie::parameter("lookahead", &WallFollow::lookahead,
                     {.unit = "m",
                      .above = 0,
                      .meaning = "it steers to a point this far on; shorter is sharper"}),
    elsie::parameter("turn_rate", &WallFollow::turn_rate,
                     {.unit = "rad/s",
                      .above = 0,
                      .max = 100,
                      .meaning = "fastest turn, in radians per second"}),
    elsie::raises("wall_found", "it has a wall to follow"),
    elsie::raises("wall_lost", "it has driven around the end of the wall and has lost it"));

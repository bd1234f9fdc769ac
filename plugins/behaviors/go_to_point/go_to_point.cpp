// Drives to a place and stops there.
#include <algorithm>
#include <cmath>

#include <elsie/api/behavior.h>
#include <elsie/api/remember.h>

namespace {

class GoToPoint final : public elsie::Behavior, public elsie::Remembers {
 public:
  double x = 0.0;
  double y = 0.0;
  double speed = 0.4;
  double gain = 3.0;
  double slow_down = 0.3;
  double tolerance = 0.05;

  elsie::Response respond(const elsie::Perception& now) override {
    const elsie::OwnState& self = now.self();
    const double away = std::hypot(x - self.pose.x, y - self.pose.y);
    elsie::Response response;
    if (away <= tolerance) {
      response.activation = 0.0;
      if (!arrived_) {
        response.events.push_back({"arrived"});
      }
      arrived_ = true;
      return response;
    }
    arrived_ = false;
    // Turns towards the place, and drives faster the better it is ahead; if it is behind, the robot
    // turns in place.
    const double off = elsie::bearing(self.pose, x, y);
    const double forward = speed * std::max(0.0, std::cos(off)) * std::min(1.0, away / slow_down);
    response.command = {forward, 0.0, gain * off};
    return response;
  }

  void reset(elsie::Random&) override { arrived_ = false; }
  void remember(elsie::Memory& memory) override { memory("arrived", arrived_); }

 private:
  bool arrived_ = false;
};

}  // namespace

ELSIE_BEHAVIOR(
    GoToPoint, "go_to_point", "Drives to a place and stops there; not active once it is there",
    elsie::parameter("x", &GoToPoint::x, {.unit = "m", .meaning = "the place, east"}),
    elsie::parameter("y", &GoToPoint::y, {.unit = "m", .meaning = "the place, north"}),
    elsie::parameter(
        "speed", &GoToPoint::speed,
        {.unit = "m/s", .min = 0, .meaning = "speed when the place lies straight ahead"}),
    elsie::parameter(
        "gain", &GoToPoint::gain,
        {.unit = "1/s", .min = 0, .meaning = "turn rate for each radian off the direction"}),
    elsie::parameter(
        "slow_down", &GoToPoint::slow_down,
        {.unit = "m", .above = 0, .meaning = "nearer than this it drives more slowly"}),
    elsie::parameter("tolerance", &GoToPoint::tolerance,
                     {.unit = "m", .above = 0, .meaning = "nearer than this, it has arrived"}),
    elsie::raises("arrived", "the robot has come within the tolerance of the place"));

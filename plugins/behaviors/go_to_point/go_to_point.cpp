// Drives to a place and stops there.
#include <cmath>

#include <elsie/api/remember.h>

#include "going.h"

namespace {

class GoToPoint final : public Going, public elsie::Remembers {
 public:
  double x = 0.0;
  double y = 0.0;
  double tolerance = 0.05;

  elsie::Response respond(const elsie::Perception& now) override {
    const elsie::Pose& here = now.self().pose;
    const double away = std::hypot(x - here.x, y - here.y);
    elsie::Response response;
    if (away <= tolerance) {
      response.activation = 0.0;
      response.status = elsie::Status::success;
      if (!arrived_) {
        response.events.push_back({"arrived"});
      }
      arrived_ = true;
      return response;
    }
    arrived_ = false;
    response.command = towards(here, x, y, away);
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
    speed_of_going(), gain_of_going(), slow_down_of_going(),
    elsie::parameter("tolerance", &GoToPoint::tolerance,
                     {.unit = "m", .above = 0, .meaning = "nearer than this, it has arrived"}),
    elsie::raises("arrived", "the robot has come within the tolerance of the place"));

// The motor schema move-to-goal (Arkin 1989): full speed far away, and a speed that falls linearly
// within the controlled zone around the place.
#include <algorithm>
#include <cmath>

#include "arrival.h"
#include "inactive.h"
#include "motor_schema.h"

namespace {

class MoveTo final : public MotorSchema, public elsie::Remembers {
 public:
  double x = 0.0;
  double y = 0.0;
  double speed = 0.3;
  double controlled = 0.5;
  double tolerance = 0.02;

  void reset(elsie::Random& random) override {
    MotorSchema::reset(random);
    arrival_.reset();
  }
  void remember(elsie::Memory& memory) override { arrival_.remember(memory); }

  elsie::Response respond(const elsie::Perception& now) override {
    const elsie::Vector2 from = here(now);
    const elsie::Vector2 way{x - from.x, y - from.y};
    const double away = std::hypot(way.x, way.y);
    elsie::Response response;
    if (away <= tolerance) {
      rest();
      response = inactive();
    } else {
      const double pull = speed * std::min(1.0, away / controlled);
      response = moved_in_world({pull * way.x / away, pull * way.y / away}, now);
    }
    arrival_.tell(away <= tolerance, "arrived", response);
    return response;
  }

 private:
  Arrival arrival_;
};

}  // namespace

ELSIE_BEHAVIOR(
    MoveTo, "move_to", "A vector towards a place, which becomes shorter near it; a motor schema",
    elsie::parameter("x", &MoveTo::x,
                     {.unit = "m", .min = -1e6, .max = 1e6, .meaning = "the place, east"}),
    elsie::parameter("y", &MoveTo::y,
                     {.unit = "m", .min = -1e6, .max = 1e6, .meaning = "the place, north"}),
    elsie::parameter(
        "speed", &MoveTo::speed,
        {.unit = "m/s", .min = 0, .max = 50, .meaning = "length of the vector, far away"}),
    elsie::parameter("controlled", &MoveTo::controlled,
                     {.unit = "m",
                      .above = 0,
                      .max = 1e6,
                      .meaning = "radius of the zone in which the vector becomes shorter"}),
    elsie::parameter("tolerance", &MoveTo::tolerance,
                     {.unit = "m", .above = 0, .meaning = "nearer than this, it has arrived"}),
    elsie::parameter("lead", &MoveTo::lead, MotorSchema::lead_facts()),
    elsie::raises("arrived", "it has come within the tolerance of the place"));

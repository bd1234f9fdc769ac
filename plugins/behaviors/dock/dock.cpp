// The motor schema docking (Arkin and Murphy 1990): comes to a place from a given direction. Far
// away it pulls to the place; around it, a vector leads to the side of the approach; within the
// cone of the approach it pulls onto the axis, and to the place along it.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "arrival.h"
#include "inactive.h"
#include "motor_schema.h"
#include "two_values.h"

namespace {

class Dock final : public MotorSchema, public elsie::Remembers {
 public:
  double x = 0.0;
  double y = 0.0;
  double approach_deg = 0.0;
  double speed = 0.3;
  double controlled = 0.6;
  double coercive = 0.5;
  double cone_deg = 45.0;
  double guidance = 2.0;
  double tolerance = 0.02;

  void configured() override {
    if (coercive > controlled) {
      throw std::invalid_argument(
          two_values("coercive", coercive, "controlled", controlled, "m") +
          "it leads around the place more slowly than it comes, so coercive must not be the larger "
          "one");
    }
    if (tolerance >= coercive) {
      throw std::invalid_argument(
          two_values("tolerance", tolerance, "coercive", coercive, "m") +
          "it would have docked before it is led to the approach, so tolerance must be the smaller "
          "one");
    }
  }

  void reset(elsie::Random& random) override {
    MotorSchema::reset(random);
    arrival_.reset();
  }
  void remember(elsie::Memory& memory) override { arrival_.remember(memory); }

  elsie::Response respond(const elsie::Perception& now) override {
    const elsie::Vector2 from = here(now);
    const double away = std::hypot(from.x - x, from.y - y);
    elsie::Response response;
    if (away <= tolerance) {
      rest();
      response = inactive();
    } else {
      response = come(from, away, now);
    }
    arrival_.tell(away <= tolerance, "docked", response);
    return response;
  }

 private:
  elsie::Motion come(const elsie::Vector2& from, double away, const elsie::Perception& now) {
    // In the frame of the dock: `before` it, on the side of the approach, and `left` of the axis,
    // as seen on the approach.
    const double c = std::cos(elsie::radians(approach_deg));
    const double s = std::sin(elsie::radians(approach_deg));
    const double before = -(c * (from.x - x) + s * (from.y - y));
    const double left = c * (from.y - y) - s * (from.x - x);
    elsie::Vector2 way = direction(before, left, away);
    const double scale = speed * std::min(1.0, away / controlled) / std::hypot(way.x, way.y);
    way = {scale * way.x, scale * way.y};
    return moved_in_world({c * way.x - s * way.y, s * way.x + c * way.y}, now);
  }

  /// Ahead and to the left, as seen on the approach; of any length but zero.
  elsie::Vector2 direction(double before, double left, double away) const {
    if (away > coercive) return {before, -left};
    const double off = std::atan2(left, before);  // from the axis, around the dock
    if (std::abs(off) <= elsie::radians(cone_deg)) return {before, -guidance * left};
    // Around the dock, on the shorter way to the axis.
    return off > 0.0 ? elsie::Vector2{-left, -before} : elsie::Vector2{left, before};
  }

  Arrival arrival_;
};

}  // namespace

ELSIE_BEHAVIOR(
    Dock, "dock", "A vector to a place, and around it to where it is approached; a motor schema",
    elsie::parameter("x", &Dock::x,
                     {.unit = "m", .min = -1e6, .max = 1e6, .meaning = "the dock, east"}),
    elsie::parameter("y", &Dock::y,
                     {.unit = "m", .min = -1e6, .max = 1e6, .meaning = "the dock, north"}),
    elsie::parameter("approach_deg", &Dock::approach_deg,
                     {.unit = "deg",
                      .min = -360,
                      .max = 360,
                      .meaning = "heading in which the robot comes to the dock"}),
    elsie::parameter(
        "speed", &Dock::speed,
        {.unit = "m/s", .min = 0, .max = 50, .meaning = "length of the vector, far away"}),
    elsie::parameter("controlled", &Dock::controlled,
                     {.unit = "m",
                      .above = 0,
                      .max = 1e6,
                      .meaning = "radius of the zone in which the vector becomes shorter"}),
    elsie::parameter("coercive", &Dock::coercive,
                     {.unit = "m",
                      .above = 0,
                      .max = 1e6,
                      .meaning = "radius of the zone in which it leads around to the approach"}),
    elsie::parameter("cone_deg", &Dock::cone_deg,
                     {.unit = "deg",
                      .above = 0,
                      .max = 89,
                      .meaning = "half the angle of the guiding zone, at the dock"}),
    elsie::parameter(
        "guidance", &Dock::guidance,
        {.min = 1,
         .max = 100,
         .meaning = "pull to the axis, relative to that along it; above 1, it comes in "
                    "along the axis"}),
    elsie::parameter("tolerance", &Dock::tolerance,
                     {.unit = "m", .above = 0, .meaning = "nearer than this, it has docked"}),
    elsie::parameter("lead", &Dock::lead, MotorSchema::lead_facts()),
    elsie::raises("docked", "it has come within the tolerance of the dock"));

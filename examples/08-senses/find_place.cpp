// Drives to a place that it knows by its coordinates: a gps tells where it is, a compass how it
// looks.
#include <cmath>

#include <elsie/api/behavior.h>
#include <elsie/readings/compass.h>
#include <elsie/readings/gps.h>

class FindPlace final : public elsie::Behavior {
 public:
  double x = 0.0, y = 0.0;
  double speed = 0.2;

  elsie::Response respond(const elsie::Perception& now) override {
    const auto here = now.readings<elsie::GpsReading>()[0];
    const auto compass = now.readings<elsie::CompassReading>()[0];
    const double way_m = std::hypot(x - here->x_m, y - here->y_m);
    const double towards = std::atan2(y - here->y_m, x - here->x_m);
    const double off = elsie::wrap_angle(towards - compass->heading_rad);
    return elsie::Motion{way_m < 0.1 ? 0.0 : speed * std::max(0.0, std::cos(off)), 0.0, 2.0 * off};
  }
};

ELSIE_BEHAVIOR(FindPlace, "find_place", "Drives to a place by gps and compass",
               elsie::needs<elsie::GpsReading>(), elsie::needs<elsie::CompassReading>(),
               elsie::parameter("x", &FindPlace::x, {.unit = "m", .meaning = "of the place, east"}),
               elsie::parameter("y", &FindPlace::y,
                                {.unit = "m", .meaning = "of the place, north"}),
               elsie::parameter("speed", &FindPlace::speed,
                                {.unit = "m/s", .min = 0, .max = 10, .meaning = "ahead"}));

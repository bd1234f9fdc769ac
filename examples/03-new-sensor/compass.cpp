#include <elsie/api/sensor.h>

#include "compass_reading.h"

// A compass, with the error that iron nearby makes: constant during a run, and noise.
class Compass final : public elsie::SensorOf<CompassReading> {
 public:
  double deviation_deg = 0.0;
  double error_deg = 0.0;

  CompassReading sense(const elsie::SensorContext& now) override {
    const double noise = error_deg > 0.0 ? error_deg * now.random->normal() : 0.0;
    return {
        elsie::wrap_angle(now.world->pose().heading_rad + elsie::radians(deviation_deg + noise))};
  }
};

ELSIE_SENSOR(
    Compass, "compass", "Tells which way the robot looks",
    elsie::parameter("deviation_deg", &Compass::deviation_deg,
                     {.unit = "deg", .min = -180, .max = 180, .meaning = "what it is off, always"}),
    elsie::parameter(
        "error_deg", &Compass::error_deg,
        {.unit = "deg", .min = 0, .max = 90, .meaning = "standard deviation of its noise"}));

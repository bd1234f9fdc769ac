#include <elsie/api/sensor.h>

#include "gyrocompass_reading.h"

// A gyrocompass, with the error of its mounting, constant during a run, and noise.
class Gyrocompass final : public elsie::SensorOf<GyrocompassReading> {
 public:
  double deviation_deg = 0.0;
  double error_deg = 0.0;

  GyrocompassReading sense(const elsie::SensorContext& now) override {
    const double noise = error_deg > 0.0 ? error_deg * now.random->normal() : 0.0;
    return {
        elsie::wrap_angle(now.world->pose().heading_rad + elsie::radians(deviation_deg + noise))};
  }
};

ELSIE_SENSOR(
    Gyrocompass, "gyrocompass", "Tells which way the robot looks",
    elsie::parameter("deviation_deg", &Gyrocompass::deviation_deg,
                     {.unit = "deg", .min = -180, .max = 180, .meaning = "what it is off, always"}),
    elsie::parameter(
        "error_deg", &Gyrocompass::error_deg,
        {.unit = "deg", .min = 0, .max = 90, .meaning = "standard deviation of its noise"}));

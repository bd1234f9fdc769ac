// The charge of the robot's battery, as a reading that may have noise, and fail.
#include <elsie/api/sensor.h>
#include <elsie/readings/battery.h>

namespace {

class Battery final : public elsie::SensorOf<elsie::BatteryReading> {
 public:
  elsie::BatteryReading sense(const elsie::SensorContext& now) override {
    const elsie::OwnState& self = now.world->self();
    return {self.capacity > 0.0 ? self.energy / self.capacity : 0.0, self.energy, self.charging};
  }
};

}  // namespace

ELSIE_SENSOR(Battery, "battery", "Measures the charge of the battery");

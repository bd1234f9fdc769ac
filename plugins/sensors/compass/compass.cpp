// A compass: where its forward axis points, in the plane of the floor.
#include <cmath>
#include <numbers>

#include <elsie/api/sensor.h>
#include <elsie/readings/compass.h>

namespace {

class Compass final : public elsie::SensorOf<elsie::CompassReading> {
 public:
  elsie::CompassReading sense(const elsie::SensorContext& now) override {
    const double heading = std::atan2(now.frame.forward.y, now.frame.forward.x);
    return {heading, elsie::wrap_angle(0.5 * std::numbers::pi - heading)};
  }

  void sketch(elsie::Sketch& sketch) const override {
    const double north = current().north_rad;
    sketch.arrow(elsie::SketchRole::belief, {},
                 {0.1 * std::cos(north), 0.1 * std::sin(north), 0.0});
  }
};

}  // namespace

ELSIE_SENSOR(Compass, "compass", "Tells the direction of north");

// Satellite navigation: the place of the sensor in the world. Give it <noise> to be a real one.
#include <cmath>

#include <elsie/api/sensor.h>
#include <elsie/readings/gps.h>

namespace {

class Gps final : public elsie::SensorOf<elsie::GpsReading> {
 public:
  elsie::GpsReading sense(const elsie::SensorContext& now) override {
    const elsie::Vector3& place = now.frame.origin;
    const elsie::Vector3 velocity = now.world->motion().velocity;
    return {place.x, place.y, place.z, std::hypot(velocity.x, velocity.y)};
  }

  void sketch(elsie::Sketch& sketch) const override {
    sketch.in_world();
    sketch.point(elsie::SketchRole::belief, {current().x_m, current().y_m, current().z_m});
  }
};

}  // namespace

ELSIE_SENSOR(Gps, "gps", "Tells its place in the world");

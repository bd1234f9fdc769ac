// A proximity switch: detects whether anything is inside a rectangular pyramid in front of it.
#include <elsie/api/sensor.h>

namespace {

class Proximity final : public elsie::SensorOf<elsie::ProximityReading> {
 public:
  double horizontal_fov_deg = 40.0;
  double vertical_fov_deg = 5.0;
  double max_range = 0.5;
  double error = 0.0;

  elsie::ProximityReading sense(const elsie::SensorContext& now) override {
    bool detected = now.world->anything_in({now.frame, elsie::radians(horizontal_fov_deg),
                                            elsie::radians(vertical_fov_deg), max_range});
    if (error > 0.0 && now.random->chance(error)) {
      detected = !detected;
    }
    return {detected, max_range};
  }

  void sketch(elsie::Sketch& sketch) const override {
    using elsie::SketchRole;
    sketch.pyramid(current().detected ? SketchRole::hit : SketchRole::range,
                   elsie::radians(horizontal_fov_deg), elsie::radians(vertical_fov_deg), max_range);
  }
};

}  // namespace

ELSIE_SENSOR(
    Proximity, "proximity",
    "Detects whether anything is inside a rectangular pyramid in front of it",
    elsie::parameter("horizontal_fov_deg", &Proximity::horizontal_fov_deg,
                     {.unit = "deg", .above = 0, .max = 170, .meaning = "full horizontal angle"}),
    elsie::parameter("vertical_fov_deg", &Proximity::vertical_fov_deg,
                     {.unit = "deg", .above = 0, .max = 170, .meaning = "full vertical angle"}),
    elsie::parameter("max_range", &Proximity::max_range,
                     {.unit = "m", .above = 0, .meaning = "height of the pyramid, along its axis"}),
    elsie::parameter("error", &Proximity::error,
                     {.min = 0, .max = 1, .meaning = "probability that a reading is inverted"}));

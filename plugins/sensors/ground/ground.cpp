// A sensor that looks straight down at the floor.
//
// Its law is that of ARGoS' ground sensors: grey / 255, or 0 and 1 with a threshold. The weights of
// the grey are those of ITU-R BT.601.
#include <elsie/api/sensor.h>
#include <elsie/readings/ground.h>

namespace {

class Ground final : public elsie::SensorOf<elsie::GroundReading> {
 public:
  double threshold = 0.0;

  elsie::GroundReading sense(const elsie::SensorContext& now) override {
    const elsie::Colour colour = now.world->floor_colour({now.frame.origin.x, now.frame.origin.y});
    elsie::GroundReading reading;
    reading.red = colour.red / 255.0;
    reading.green = colour.green / 255.0;
    reading.blue = colour.blue / 255.0;
    reading.grey = (0.299 * colour.red + 0.587 * colour.green + 0.114 * colour.blue) / 255.0;
    if (threshold > 0.0) reading.grey = reading.grey >= threshold ? 1.0 : 0.0;
    return reading;
  }

  void sketch(elsie::Sketch& sketch) const override { sketch.point(elsie::SketchRole::field, {}); }
};

}  // namespace

ELSIE_SENSOR(Ground, "ground", "Sees the colour of the floor below it",
             elsie::parameter(
                 "threshold", &Ground::threshold,
                 {.min = 0,
                  .max = 1,
                  .meaning = "grey from which on it reads 1, and 0 below; 0: it reads the grey"}));

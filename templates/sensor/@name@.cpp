// @name@: what it senses, in a sentence; and a behaviour that reads it, in the same library. A sensor
// alone needs no behaviour: remove it here, in the test and in the world.
#include <cmath>

#include <elsie/api/behavior.h>
#include <elsie/api/sensor.h>

#include "@name@_reading.h"

class @Class@ final : public elsie::SensorOf<@Class@Reading> {
 public:
  // Parameters of the world file. Their defaults are set only here.
  double lamp_x = 0.0;  // m
  double lamp_y = 0.0;  // m
  double error = 0.0;   // a part of the brightness

  // Called in every control period. `now.world` casts rays; elsie/api/sensor.h lists what else it has.
  @Class@Reading sense(const elsie::SensorContext& now) override {
    const auto& eye = now.frame.origin;  // the sensor's own place in the world
    const double distance = std::hypot(lamp_x - eye.x, lamp_y - eye.y);
    const double noise = error > 0.0 ? error * now.random->normal() : 0.0;
    return {(1.0 + noise) / (1.0 + distance * distance)};
  }

  // What pictures, recordings and the window draw of it: docs/writing-a-sensor.md.
  void sketch(elsie::Sketch& sketch) const override {
    sketch.in_world();
    sketch.point(elsie::SketchRole::hit, {lamp_x, lamp_y, 0.0});
  }
};

ELSIE_SENSOR(@Class@, "@name@", "Sees how bright a lamp is",
             elsie::parameter("lamp_x", &@Class@::lamp_x,
                              {.unit = "m", .min = -1000, .max = 1000, .meaning = "position of the lamp"}),
             elsie::parameter("lamp_y", &@Class@::lamp_y,
                              {.unit = "m", .min = -1000, .max = 1000, .meaning = "position of the lamp"}),
             elsie::parameter("error", &@Class@::error,
                              {.min = 0, .max = 1,
                               .meaning = "standard deviation of the noise, relative to the brightness"}));

// Turns to the side that is brighter: Braitenberg's vehicle 2b.
class Seek@Class@ final : public elsie::Behavior {
 public:
  double speed = 0.2;   // m/s
  double gain = 100.0;  // rad/s

  elsie::Response respond(const elsie::Perception& now) override {
    double balance = 0.0;  // left minus right, as a part of the sum
    double sum = 1e-9;
    for (const auto& eye : now.readings<@Class@Reading>()) {
      balance += eye.azimuth_rad() > 0.0 ? eye->brightness : -eye->brightness;
      sum += eye->brightness;
    }
    return elsie::Motion{speed, 0.0, gain * balance / sum};
  }
};

ELSIE_BEHAVIOR(Seek@Class@, "seek_@name@", "Turns to the side that is brighter",
               elsie::needs<@Class@Reading>(),
               elsie::parameter("speed", &Seek@Class@::speed,
                                {.unit = "m/s", .min = 0, .max = 5, .meaning = "speed"}),
               elsie::parameter("gain", &Seek@Class@::gain,
                                {.unit = "rad/s", .min = 0, .max = 1000,
                                 .meaning = "turn rate if only one side sees light"}));

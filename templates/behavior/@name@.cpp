// @name@: what it does, in a sentence.
#include <algorithm>

#include <elsie/api/behavior.h>

class @Class@ final : public elsie::Behavior {
 public:
  // Parameters of the world file. Their defaults are set only here.
  double speed = 10.0;
  double distance = 0.5;

  // What it shows: a column of tables, a channel of recordings, a curve in the window.
  double nearest = 0.0;  // m

  void reset(elsie::Random&) override { nearest = distance; }

  elsie::Response respond(const elsie::Perception& now) override {
    nearest = distance;
    for (const auto& beam : now.readings<elsie::RangeReading>()) {
      nearest = std::min(nearest, beam->distance_m);
    }
    // Slower with nearness; at half the distance it stands still.
    const double rate = speed * std::max(0.0, 2.0 * nearest / distance - 1.0);
    elsie::Response response = now.self().wheels.motion({rate, rate});
    response.activation = 1.0 - nearest / distance;  // grows with nearness
    return response;
  }
};

ELSIE_BEHAVIOR(@Class@, "@name@", "Drives on, and stops in front of obstacles",
               elsie::needs<elsie::RangeReading>(),
               elsie::parameter("speed", &@Class@::speed,
                                {.unit = "rad/s", .min = 0, .max = 50,
                                 .meaning = "wheel rate when all is clear"}),
               elsie::parameter("distance", &@Class@::distance,
                                {.unit = "m", .above = 0, .max = 100,
                                 .meaning = "it slows down for obstacles nearer than this"}),
               elsie::publishes("nearest", &@Class@::nearest,
                                {.unit = "m", .meaning = "to the nearest obstacle that it minds"}));

#include <algorithm>

#include <elsie/api/behavior.h>

// Drives on, and backs away from what comes too near.
class Shy final : public elsie::Behavior {
 public:
  double comfort = 0.3;  // the default is set only here
  double speed = 10.0;

  elsie::Response respond(const elsie::Perception& now) override {
    double nearest = comfort;
    for (const auto& beam : now.readings<elsie::RangeReading>()) {
      nearest = std::min(nearest, beam->distance_m);
    }
    // Full speed ahead where all is clear, full speed back where something touches.
    const double rate = speed * (2.0 * nearest / comfort - 1.0);
    return now.self().wheels.motion({rate, rate});
  }
};

ELSIE_BEHAVIOR(
    Shy, "shy", "Drives on, and backs away from what comes too near",
    elsie::needs<elsie::RangeReading>(),
    elsie::parameter("comfort", &Shy::comfort,
                     {.unit = "m", .above = 0, .meaning = "distance it likes to keep"}),
    elsie::parameter("speed", &Shy::speed,
                     {.unit = "rad/s", .min = 0, .meaning = "wheel rate when all is clear"}));

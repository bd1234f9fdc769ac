#include <algorithm>

#include <elsie/api/behavior.h>

// Drives on, and the slower the nearer something is.
class Hesitate final : public elsie::Behavior {
 public:
  double caution = 0.5;
  double speed = 10.0;
  double slowest = 0.3;

  elsie::Response respond(const elsie::Perception& now) override {
    double nearest = caution;
    for (const auto& beam : now.readings<elsie::RangeReading>()) {
      nearest = std::min(nearest, beam->distance_m);
    }
    const double rate = speed * std::max(slowest, nearest / caution);
    return now.self().wheels.motion({rate, rate});
  }
};

ELSIE_BEHAVIOR(
    Hesitate, "hesitate", "Drives on, and the slower the nearer something is",
    elsie::needs<elsie::RangeReading>(),
    elsie::parameter("caution", &Hesitate::caution,
                     {.unit = "m", .above = 0, .meaning = "from where on it slows down"}),
    elsie::parameter("speed", &Hesitate::speed,
                     {.unit = "rad/s", .min = 0, .meaning = "wheel rate when all is clear"}),
    elsie::parameter(
        "slowest", &Hesitate::slowest,
        {.min = 0, .max = 1, .meaning = "share of the speed that is left at a touch"}));

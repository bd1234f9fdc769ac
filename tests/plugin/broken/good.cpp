// A library as it should be, with a plugin of each kind.
#include "elsie/api/behavior.h"
#include "elsie/api/coordinator.h"
#include "elsie/api/sensor.h"

struct LightReading {
  static constexpr const char* kind = "light";
  double lux = 0.0;
};

class Light final : public elsie::SensorOf<LightReading> {
 public:
  LightReading sense(const elsie::SensorContext&) override { return {7.0}; }
};

class Steady final : public elsie::Behavior {
 public:
  double speed = 3.0;
  elsie::Response respond(const elsie::Perception&) override {
    return elsie::WheelPair().motion({speed, speed});
  }
};

class First final : public elsie::Coordinator {
 public:
  elsie::Motion coordinate(std::span<elsie::Member> members, const elsie::Perception&) override {
    return members.empty() ? elsie::Motion{} : members.front().respond().command;
  }
};

ELSIE_SENSOR(Light, "good", "Sees light");
ELSIE_BEHAVIOR(Steady, "good", "Drives on",
               elsie::parameter("speed", &Steady::speed, {.unit = "rad/s", .min = 0, .max = 50}));
ELSIE_COORDINATOR(First, "good", "Does as the first behaviour says", elsie::version("2.5"));

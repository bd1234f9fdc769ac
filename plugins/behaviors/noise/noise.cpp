// The motor schema noise (Arkin 1989): a vector in a random direction of the world, which persists
// for a given time. It gets robots out of the local minima of other schemas.
#include <cmath>
#include <limits>
#include <numbers>

#include <elsie/api/remember.h>

#include "motor_schema.h"

namespace {

class Noise final : public MotorSchema, public elsie::Remembers {
 public:
  double gain = 0.1;
  double persistence = 1.0;

  void reset(elsie::Random& random) override {
    MotorSchema::reset(random);
    until_s_ = kBefore;
    direction_rad_ = 0.0;
  }
  void remember(elsie::Memory& memory) override {
    memory("until_s", until_s_);
    memory("direction_rad", direction_rad_);
  }

  elsie::Response respond(const elsie::Perception& now) override {
    if (now.time_s() >= until_s_ - kRounding) {
      direction_rad_ = now.random().uniform(-std::numbers::pi, std::numbers::pi);
      until_s_ = now.time_s() + persistence;
    }
    return moved_in_world({gain * std::cos(direction_rad_), gain * std::sin(direction_rad_)}, now);
  }

 private:
  static constexpr double kBefore = std::numeric_limits<double>::lowest();
  static constexpr double kRounding = 1e-9;  // s: times of steps are sums of periods

  double until_s_ = kBefore;
  double direction_rad_ = 0.0;  // in the world
};

}  // namespace

ELSIE_BEHAVIOR(
    Noise, "noise", "A vector in a random direction, which persists for a while; a motor schema",
    elsie::parameter("gain", &Noise::gain,
                     {.unit = "m/s", .min = 0, .max = 50, .meaning = "length of the vector"}),
    elsie::parameter("persistence", &Noise::persistence,
                     {.unit = "s",
                      .min = 0,
                      .max = 1e9,
                      .meaning = "how long it keeps a direction; 0: one control period"}),
    elsie::parameter("lead", &Noise::lead, MotorSchema::lead_facts()));

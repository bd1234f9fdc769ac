// Shines with the robot's lamp, on and off.
#include <cmath>

#include <elsie/api/behavior.h>
#include <elsie/commands/led.h>

class Signal final : public elsie::Behavior {
 public:
  double period = 0.4;  // s

  elsie::Response respond(const elsie::Perception& now) override {
    const bool on = std::fmod(now.time_s(), period) < 0.75 * period;
    elsie::Response response;
    response.act(elsie::LedCommand{{255, 200, 0}, on ? 1.0 : 0.0});
    return response;
  }
};

ELSIE_BEHAVIOR(
    Signal, "signal", "Shines with the robot's lamp, on and off", elsie::only_acts(),
    elsie::commands<elsie::LedCommand>(),
    elsie::parameter("period", &Signal::period,
                     {.unit = "s", .above = 0, .max = 1000, .meaning = "from on to on"}));

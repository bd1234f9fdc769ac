// Fireflies: each robot blinks once in a period, and blinks a little earlier for each other one
// that it sees blinking (pulse-coupled oscillators; Mirollo and Strogatz 1990, on robots
// Christensen et al. 2009).
#include <algorithm>

#include <elsie/api/behavior.h>
#include <elsie/commands/led.h>
#include <elsie/readings/omnidirectional_camera.h>

constexpr elsie::Colour kFlash{255, 210, 0};

class Blink final : public elsie::Behavior {
 public:
  double period = 1.0;    // s
  double coupling = 0.1;  // part of the phase that a flash adds to it
  double flash = 0.1;     // s

  void reset(elsie::Random& random) override {
    phase_ = random.uniform();
    asked_s_ = lit_until_s_ = 0.0;
    lit_ = 0;
  }

  elsie::Response respond(const elsie::Perception& now) override {
    phase_ += (now.time_s() - asked_s_) / period;
    asked_s_ = now.time_s();
    const auto& blobs = now.readings<elsie::OmnidirectionalReading>()[0]->blobs;
    const auto lit = std::count_if(blobs.begin(), blobs.end(),
                                   [](const auto& blob) { return blob.colour() == kFlash; });
    if (lit > lit_ && phase_ > flash / period) {  // deaf while it shines itself
      phase_ *= 1.0 + coupling * static_cast<double>(lit - lit_);
    }
    lit_ = lit;
    elsie::Response response;
    if (phase_ >= 1.0) {
      phase_ = 0.0;
      lit_until_s_ = now.time_s() + flash;
      response.events.push_back({"flash"});
    }
    response.act(elsie::LedCommand{kFlash, now.time_s() < lit_until_s_ ? 1.0 : 0.0});
    return response;
  }

  double phase_ = 0.0;  // in [0, 1)

 private:
  double asked_s_ = 0.0;
  double lit_until_s_ = 0.0;
  std::ptrdiff_t lit_ = 0;  // the others that it saw shining
};

ELSIE_BEHAVIOR(
    Blink, "blink", "Blinks, and falls in step with what it sees blinking", elsie::only_acts(),
    elsie::needs<elsie::OmnidirectionalReading>(), elsie::commands<elsie::LedCommand>(),
    elsie::raises("flash", "its lamp goes on"),
    elsie::parameter("period", &Blink::period,
                     {.unit = "s", .above = 0, .max = 1000, .meaning = "alone"}),
    elsie::parameter(
        "coupling", &Blink::coupling,
        {.min = 0, .max = 1, .meaning = "what a flash adds to the phase, as a part of it"}),
    elsie::parameter("flash", &Blink::flash,
                     {.unit = "s", .above = 0, .max = 1000, .meaning = "how long its lamp is on"}),
    elsie::publishes("phase", &Blink::phase_, {.meaning = "from flash to flash"}));

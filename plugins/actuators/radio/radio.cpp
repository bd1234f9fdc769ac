// Radio: what a behaviour says is heard once, by every robot with a radio in range or by one of
// them, whatever stands between.
#include <cstdint>

#include <elsie/api/actuator.h>

namespace {

class Radio final : public elsie::ActuatorOf<elsie::SayCommand> {
 public:
  double range = 1.5;
  double delay = 0.0;
  double loss = 0.0;
  std::uint32_t bandwidth = 64;

  void act(const elsie::SayCommand& said, const elsie::ActuatorContext& now) override {
    if (!said.message || !now.is_new) return;
    now.robot->transmit(said.message, said.to,
                        {.range_m = range, .delay_s = delay, .loss = loss, .bandwidth = bandwidth});
  }

  void sketch(elsie::Sketch& sketch) const override {
    if (current().message) sketch.circle(elsie::SketchRole::range, {}, range);
  }
};

}  // namespace

ELSIE_ACTUATOR(Radio, "radio", "Sends what a behaviour says, and hears other radios",
               elsie::hears_messages(),
               elsie::parameter("range", &Radio::range,
                                {.unit = "m",
                                 .above = 0,
                                 .max = 1e4,
                                 .meaning = "robots within it hear what this one says"}),
               elsie::parameter("delay", &Radio::delay,
                                {.unit = "s",
                                 .min = 0,
                                 .max = 1000,
                                 .meaning = "until it is heard; at least until the next control "
                                            "period"}),
               elsie::parameter("loss", &Radio::loss,
                                {.min = 0,
                                 .max = 1,
                                 .meaning = "probability that a robot hears nothing of this one in "
                                            "a control period"}),
               elsie::parameter("bandwidth", &Radio::bandwidth,
                                {.unit = "bytes",
                                 .min = 1,
                                 .max = 1e6,
                                 .meaning = "in a control period; a longer message is a fault"}));

// Range and bearing, as the foot-bot and the e-puck have it in ARGoS: it repeats what a behaviour
// has said last; robots in sight and in range hear it, and know from where.
#include <cstdint>

#include <elsie/api/actuator.h>

namespace {

class RangeAndBearing final : public elsie::ActuatorOf<elsie::SayCommand> {
 public:
  double range = 3.0;
  double loss = 0.0;
  std::uint32_t bandwidth = 10;
  bool tells_id = false;

  void act(const elsie::SayCommand& said, const elsie::ActuatorContext& now) override {
    if (!said.message) return;
    now.robot->transmit(said.message, said.to,
                        {.range_m = range,
                         .loss = loss,
                         .in_sight = true,
                         .tells_from = tells_id,
                         .bandwidth = bandwidth});
  }
};

}  // namespace

ELSIE_ACTUATOR(
    RangeAndBearing, "range_and_bearing",
    "Repeats what a behaviour said last to robots in sight, and hears from where they speak",
    elsie::hears_messages(),
    elsie::parameter("range", &RangeAndBearing::range,
                     {.unit = "m",
                      .above = 0,
                      .max = 1e4,
                      .meaning = "robots within it hear what this one says"}),
    elsie::parameter("loss", &RangeAndBearing::loss,
                     {.min = 0,
                      .max = 1,
                      .meaning = "probability that a robot hears nothing of this one in "
                                 "a control period"}),
    elsie::parameter("bandwidth", &RangeAndBearing::bandwidth,
                     {.unit = "bytes",
                      .min = 1,
                      .max = 1e6,
                      .meaning = "of a message; a longer one is a fault"}),
    elsie::parameter("tells_id", &RangeAndBearing::tells_id,
                     {.meaning = "whether those who hear it know who speaks"}));

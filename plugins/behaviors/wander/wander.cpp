// Drives on and changes its direction now and then.
#include <elsie/api/behavior.h>
#include <elsie/api/remember.h>

namespace {

class Wander final : public elsie::Behavior, public elsie::Remembers {
 public:
  double speed = 10.0;
  double restlessness = 0.2;
  double turn = 3.0;

  elsie::Response respond(const elsie::Perception& now) override {
    if (now.random().chance(restlessness * now.period_s())) {
      bias_ = now.random().uniform(-turn, turn);
    }
    return now.self().wheels.motion({speed - bias_, speed + bias_});
  }

  void reset(elsie::Random&) override { bias_ = 0.0; }
  void remember(elsie::Memory& memory) override { memory("bias", bias_); }

 private:
  double bias_ = 0.0;  // rad/s
};

}  // namespace

ELSIE_BEHAVIOR(
    Wander, "wander", "Drives on, and changes its mind about the direction now and then",
    elsie::parameter("speed", &Wander::speed,
                     {.unit = "rad/s", .min = 0, .max = 500, .meaning = "mean wheel rate"}),
    elsie::parameter("restlessness", &Wander::restlessness,
                     {.unit = "1/s", .min = 0, .meaning = "changes of mind a second"}),
    elsie::parameter(
        "turn", &Wander::turn,
        {.unit = "rad/s",
         .min = 0,
         .max = 500,
         .meaning = "a new direction makes the wheels differ from the mean by up to this"}));

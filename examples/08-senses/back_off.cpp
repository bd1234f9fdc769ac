// Drives on until a bumper is pressed; then backs off and turns away.
#include <elsie/api/behavior.h>
#include <elsie/readings/bumper.h>

class BackOff final : public elsie::Behavior {
 public:
  double speed = 0.3;

  elsie::Response respond(const elsie::Perception& now) override {
    if (now.readings<elsie::BumperReading>()[0]->pressed) pressed_s_ = now.time_s();
    const double since_s = now.time_s() - pressed_s_;
    if (since_s < 0.8) return elsie::Motion{-0.5 * speed, 0.0, 0.0};
    if (since_s < 2.0) return elsie::Motion{0.0, 0.0, 1.5};
    return elsie::Motion{speed, 0.0, 0.0};
  }
  void reset(elsie::Random&) override { pressed_s_ = -10.0; }

 private:
  double pressed_s_ = -10.0;
};

ELSIE_BEHAVIOR(BackOff, "back_off", "Drives on, and turns away from what its bumper feels",
               elsie::needs<elsie::BumperReading>(),
               elsie::parameter("speed", &BackOff::speed,
                                {.unit = "m/s", .min = 0, .max = 10, .meaning = "straight on"}));

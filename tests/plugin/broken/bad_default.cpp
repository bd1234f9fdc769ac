// Its default is out of its own range.
#include "elsie/api/behavior.h"

class BadDefault final : public elsie::Behavior {
 public:
  double speed = 60.0;
  elsie::Response respond(const elsie::Perception&) override { return elsie::Motion{}; }
};

ELSIE_BEHAVIOR(BadDefault, "bad_default", "Wants more than it may have",
               elsie::parameter("speed", &BadDefault::speed, {.unit = "rad/s", .max = 50}));

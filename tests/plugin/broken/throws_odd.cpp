// Throws something that is no std::exception.
#include "elsie/api/behavior.h"

struct OddBall {};

class ThrowsOdd final : public elsie::Behavior {
 public:
  ThrowsOdd() { throw OddBall(); }
  elsie::Response respond(const elsie::Perception&) override { return elsie::Motion{}; }
};

ELSIE_BEHAVIOR(ThrowsOdd, "throws_odd", "Throws an object of its own type");

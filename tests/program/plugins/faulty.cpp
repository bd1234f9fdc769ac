// Behaviours that fail after half a second, for the tests of the program.
#include <limits>
#include <stdexcept>

#include <elsie/api/behavior.h>

namespace {

class Throwing final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception& now) override {
    if (now.time_s() >= 0.5) {
      throw std::runtime_error("it gave up");
    }
    return elsie::MotorCommand{10, 10};
  }
};

class NotANumber final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception& now) override {
    const double rate = now.time_s() >= 0.5 ? std::numeric_limits<double>::quiet_NaN() : 10.0;
    return elsie::MotorCommand{rate, rate};
  }
};

}  // namespace

ELSIE_BEHAVIOR(Throwing, "throwing", "Throws after half a second");
ELSIE_BEHAVIOR(NotANumber, "not_a_number", "Answers NaN after half a second");

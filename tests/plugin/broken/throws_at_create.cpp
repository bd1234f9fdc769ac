// Can be declared, but not be made a second time.
#include <stdexcept>

#include "elsie/api/behavior.h"

class SecondTime : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Once final : public elsie::Behavior {
 public:
  Once() {
    static int made = 0;
    if (++made > 1) {
      throw SecondTime("there can be only one");
    }
  }
  elsie::Response respond(const elsie::Perception&) override { return elsie::Motion{}; }
};

ELSIE_BEHAVIOR(Once, "throws_at_create", "Can be made once");

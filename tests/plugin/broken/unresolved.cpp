// Uses a function that nobody defines.
#include "elsie/api/behavior.h"

namespace nowhere {
double to_be_found(int level);
}

class Unresolved final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception&) override {
    return elsie::WheelPair().motion({nowhere::to_be_found(1), 0});
  }
};

ELSIE_BEHAVIOR(Unresolved, "unresolved", "Misses a symbol");

// An inline static in a template: without -fno-gnu-unique, the library would never be unloaded.
// (Hidden visibility would do as well, but templates of the standard library are not hidden.)
#include "elsie/api/behavior.h"

template <class T>
struct __attribute__((visibility("default"))) Counter {
  inline static int count = 0;
};

class CountsObjects final : public elsie::Behavior {
 public:
  CountsObjects() { ++Counter<int>::count; }
  elsie::Response respond(const elsie::Perception&) override {
    return elsie::WheelPair().motion({static_cast<double>(Counter<int>::count), 0});
  }
};

ELSIE_BEHAVIOR(CountsObjects, "inline_static", "Counts its objects");

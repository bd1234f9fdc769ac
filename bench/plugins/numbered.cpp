// A small plugin whose name plugin_boundary replaces in copies of its library.
#include <elsie/api/behavior.h>

// Visible, so that the compiler cannot assume its value.
__attribute__((visibility("default"))) char name_of_numbered[] = "numbered_???";

namespace {

class Numbered final : public elsie::Behavior {
 public:
  double speed = 10.0;

  elsie::Response respond(const elsie::Perception&) override {
    return elsie::WheelPair().motion({speed, speed});
  }
};

}  // namespace

ELSIE_BEHAVIOR(Numbered, name_of_numbered, "Drives straight on",
               elsie::parameter("speed", &Numbered::speed,
                                {.unit = "rad/s", .meaning = "wheel rate"}));

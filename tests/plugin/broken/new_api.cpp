// Built for another version of the plugin interface.
#include "elsie/api/abi.h"
#undef ELSIE_API_MINOR
#define ELSIE_API_MINOR 99
#include "elsie/api/behavior.h"

class Other final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception&) override { return elsie::Motion{}; }
};

ELSIE_BEHAVIOR(Other, "new_api", "Stands still");

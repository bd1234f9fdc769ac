// Built with another setting than the host.
#include "elsie/api/abi.h"
#undef ELSIE_ABI_CONTAINERS
#define ELSIE_ABI_CONTAINERS ";containers=debug"
#include "elsie/api/behavior.h"

class Other final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception&) override { return elsie::Motion{}; }
};

ELSIE_BEHAVIOR(Other, "other_abi", "Stands still");

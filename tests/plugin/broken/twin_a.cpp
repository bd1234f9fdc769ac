// One of two libraries with a plugin of the same name.
#include "elsie/api/behavior.h"

class Twin final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception&) override { return elsie::Motion{}; }
};

ELSIE_BEHAVIOR(Twin, "twin", "The first twin");

// Put together from parts that were built with different settings.
#include "elsie/api/behavior.h"

ELSIE_EMIT_ABI_NOTE_("api=0.1;containers=debug");

class Mixed final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception&) override { return elsie::Motion{}; }
};

ELSIE_BEHAVIOR(Mixed, "mixed_words", "Stands still");

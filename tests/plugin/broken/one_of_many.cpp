// The tests make a hundred libraries of this one, by giving each another name.
#include "elsie/api/behavior.h"

extern const char one_of_many_name[];

class OneOfMany final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception&) override { return elsie::Motion{}; }
};

ELSIE_BEHAVIOR(OneOfMany, one_of_many_name, "One of a hundred");

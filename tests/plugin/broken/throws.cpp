// Its class cannot be made, which the declaration notices.
#include <stdexcept>
#include <string>

#include "elsie/api/behavior.h"

class OutOfOrder : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Throws final : public elsie::Behavior {
 public:
  Throws() { throw OutOfOrder("the model file is " + std::string("missing")); }
  elsie::Response respond(const elsie::Perception&) override { return elsie::Motion{}; }
};

ELSIE_BEHAVIOR(Throws, "throws", "Throws while it is declared");

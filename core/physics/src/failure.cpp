#include "elsie/physics/failure.h"

#include "elsie/base/number_text.h"

namespace elsie::physics {
namespace {

std::string rough(double value) { return base::number_text(value, 4); }

std::string sentence(const Failure& failure) {
  std::string what = failure.in_words();
  if (failure.body) {
    const char* const kind = failure.body->kind == BodyKind::robot ? "robot " : "box ";
    what = (failure.segment ? "segment " + std::to_string(*failure.segment) + " of " : "") + kind +
           std::to_string(failure.body->index) + " " + what;
  }
  return "The physics became unstable after " + base::number_text(failure.time_s, 6) +
         " s: " + what + ". A smaller step, or less extreme masses, torques and speeds may help.";
}

}  // namespace

std::string Failure::in_words() const {
  const std::string at =
      "(" + rough(place.x) + ", " + rough(place.y) + ", " + rough(place.z) + ") m";
  switch (kind) {
    case Kind::stopped:
      break;
    case Kind::not_finite:
      return "has a position or speed that is no longer finite";
    case Kind::below_floor:
      return "is below the floor: its middle is at " + at;
    case Kind::outside:
      return "is outside of the arena's walls: its middle is at " + at;
    case Kind::too_fast:
      return "moves at " + rough(speed) + " m/s at " + at + ", where nothing can make it " +
             "faster than " + rough(limit) + " m/s";
    case Kind::pressed:
      return "has no room left at " + at + ", pressed into what is in its way";
  }
  return "the solver stopped, because numbers grew beyond all bounds or lost all their digits";
}

PhysicsFailure::PhysicsFailure(Failure failed)
    : std::runtime_error(sentence(failed)), failure(failed) {}

}  // namespace elsie::physics

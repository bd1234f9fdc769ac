#include "elsie/physics/failure.h"

#include <array>
#include <cstdio>
#include <utility>

namespace elsie::physics {
namespace {

template <class... Numbers>
std::string text(const char* format, Numbers... numbers) {
  std::array<char, 160> written{};
  std::snprintf(written.data(), written.size(), format, numbers...);
  return written.data();
}

std::string sentence(const Failure& failure) {
  std::string what = failure.in_words();
  if (failure.body) {
    const std::string number = std::to_string(failure.body->index);
    const char* const kind = failure.body->kind == BodyKind::robot ? "robot " : "box ";
    what = (failure.segment ? "segment " + std::to_string(*failure.segment) + " of " : "") + kind +
           number + " " + what;
  }
  return "The physics became unstable after " + text("%g", failure.time_s) + " s: " + what +
         ". A smaller step, a larger cfm, or less extreme masses, torques and speeds may help.";
}

}  // namespace

std::string Failure::in_words() const {
  const std::string at = text("(%.4g, %.4g, %.4g) m", place.x, place.y, place.z);
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
      return "moves at " + text("%.4g m/s", speed) + " at " + at + ", where nothing can make it " +
             "faster than " + text("%.4g m/s", limit);
  }
  return "the solver stopped, because numbers grew beyond all bounds or lost all their digits";
}

PhysicsFailure::PhysicsFailure(Failure failed)
    : std::runtime_error(sentence(failed)), failure(std::move(failed)) {}

}  // namespace elsie::physics

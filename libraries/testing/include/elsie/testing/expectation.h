// Expectations of an answer.
//
//   const Verdict verdict = turns_left().check(shy.respond(now));   // without a test framework
//   CHECK_THAT(shy.respond(now), turns_left() && !raises("stuck"));  // Catch2, with catch.h
//
// Each checks a Response or a bare Motion.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "elsie/api/behavior.h"
#include "elsie/testing/verdict.h"

namespace elsie::testing {

class Expectation {
 public:
  /// `says` continues "the answer should ".
  Expectation(std::string says, std::function<bool(const Response&)> test)
      : says_(std::move(says)), test_(std::move(test)) {}

  /// "the answer should turn left, but is command (forward 0.05 m/s, turn -0.2 rad/s), activation
  /// 1"
  Verdict check(const Response& response) const;

  // Catch2 knows a matcher by these two functions.
  bool match(const Response& response) const { return test_(response); }
  std::string toString() const {  // NOLINT(readability-identifier-naming)
    return "should " + says_;
  }

  friend Expectation operator&&(const Expectation& a, const Expectation& b);
  friend Expectation operator||(const Expectation& a, const Expectation& b);
  Expectation operator!() const;

 private:
  std::string says_;
  std::function<bool(const Response&)> test_;
};

/// "command (forward 0.05 m/s, turn -0.2 rad/s), activation 0.5, strength 1, raises stuck"
std::string text(const Response& response);
std::string text(const Motion& motion);

// Directions. A turn (rad/s) or a speed (m/s) counts as zero below `than`.
inline constexpr double kNoRate = 1e-6;
Expectation turns_left(double than = kNoRate);
Expectation turns_right(double than = kNoRate);
/// Forward, neither sideways nor in a turn.
Expectation drives_straight_on(double than = kNoRate);
Expectation drives_forward(double than = kNoRate);
Expectation backs_up(double than = kNoRate);
/// It turns and goes nowhere.
Expectation turns_on_the_spot(double than = kNoRate);
Expectation stands(double than = kNoRate);

/// Each channel within `within` m/s or rad/s.
Expectation commands(const Motion& motion, double within = 1e-9);
/// The same for a robot with this pair of wheels; each wheel within `within` rad/s, and no lateral
/// speed.
Expectation commands_wheels(double left, double right, double within = 1e-9,
                            const WheelPair& wheels = {});

/// Activation above zero.
Expectation is_active();
Expectation is_not_active();
Expectation has_activation(double activation, double within = 1e-9);
Expectation has_strength(double strength, double within = 1e-9);
Expectation raises(std::string_view event);
Expectation raises_nothing();
Expectation asks_to_be_charged();

}  // namespace elsie::testing

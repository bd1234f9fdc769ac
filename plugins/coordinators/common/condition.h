// Conditions that users write: "battery < 0.2 or not(leader_seen)".
#pragma once

#include "expression.h"

/// An expression that is true or not: it holds if it has a value, and that is not 0.
class Condition : private Expression {
 public:
  /// Throws std::invalid_argument with a sentence.
  explicit Condition(const std::string& text) : Expression(text, "condition") {}

  using Expression::equip;
  using Expression::text;

  /// Call equip() first.
  bool holds(std::span<const elsie::Member> members, const elsie::Perception& now) {
    return value(members, now).value_or(0.0) != 0.0;
  }
};

// Formulas for the position of an output's term, after Takagi and Sugeno (1985): FUNCTION (a * 2) +
// SIN(b).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace elsie::fuzzy {

enum class FormulaOp {
  number,
  input,
  add,
  subtract,
  multiply,
  divide,
  power,
  negate,
  sine,
  cosine,
  tangent,
  exponential,
  logarithm,
  absolute,
  root,
};

struct FormulaStep {
  FormulaOp op = FormulaOp::number;
  double number = 0.0;    // only of op number
  std::size_t input = 0;  // only of op input: its index
};

/// In postfix order: numbers and inputs push a value, the others take one or two and push one.
using Formula = std::vector<FormulaStep>;

/// The greatest number of values that a formula keeps on its stack.
inline constexpr std::size_t kDeepestFormula = 32;

/// The farthest position of a term: beyond it, sums and products could overflow.
inline constexpr double kFurthestPlace = 1e100;

/// The value may be infinite or not a number, as in 1 / 0.
double value_of(const Formula& formula, std::span<const double> inputs);

}  // namespace elsie::fuzzy

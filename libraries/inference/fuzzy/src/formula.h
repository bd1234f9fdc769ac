// Formulas for the place of an output's term: FUNCTION (a * 2) + SIN(b), after Takagi and Sugeno
// (1985).
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
  double number = 0.0;    // of op number
  std::size_t input = 0;  // of op input: its place among the inputs
};

/// In postfix order: numbers and inputs push a value, the others take one or two and push one.
using Formula = std::vector<FormulaStep>;

/// No formula pushes more values than this.
inline constexpr std::size_t kDeepestFormula = 32;

/// No term may stand beyond this: sums and products could overflow.
inline constexpr double kFurthestPlace = 1e100;

/// May be infinite or not a number, as in 1 / 0.
double value_of(const Formula& formula, std::span<const double> inputs);

}  // namespace elsie::fuzzy

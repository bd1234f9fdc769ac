#include "formula.h"

#include <array>
#include <cmath>

namespace elsie::fuzzy {

double value_of(const Formula& formula, std::span<const double> inputs) {
  std::array<double, kDeepestFormula> stack{};
  std::size_t size = 0;
  for (const FormulaStep& step : formula) {
    if (step.op == FormulaOp::number || step.op == FormulaOp::input) {
      stack[size++] = step.op == FormulaOp::number ? step.number : inputs[step.input];
      continue;
    }
    const bool is_binary = step.op >= FormulaOp::add && step.op <= FormulaOp::power;
    const double b = stack[size - 1];
    size -= is_binary ? 1 : 0;
    double& a = stack[size - 1];  // the only value of the others
    switch (step.op) {
      case FormulaOp::add:
        a += b;
        break;
      case FormulaOp::subtract:
        a -= b;
        break;
      case FormulaOp::multiply:
        a *= b;
        break;
      case FormulaOp::divide:
        a /= b;
        break;
      case FormulaOp::power:
        a = std::pow(a, b);
        break;
      case FormulaOp::negate:
        a = -a;
        break;
      case FormulaOp::sine:
        a = std::sin(a);
        break;
      case FormulaOp::cosine:
        a = std::cos(a);
        break;
      case FormulaOp::tangent:
        a = std::tan(a);
        break;
      case FormulaOp::exponential:
        a = std::exp(a);
        break;
      case FormulaOp::logarithm:
        a = std::log(a);
        break;
      case FormulaOp::absolute:
        a = std::abs(a);
        break;
      case FormulaOp::root:
        a = std::sqrt(a);
        break;
      case FormulaOp::number:
      case FormulaOp::input:
        break;  // above
    }
  }
  return stack[0];
}

}  // namespace elsie::fuzzy

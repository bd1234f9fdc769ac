// Computes the degrees of rules from inputs.
#include <algorithm>
#include <limits>

#include "elsie/fuzzy/sets.h"

#include "inference.h"
#include "shapes.h"

namespace elsie::fuzzy {

namespace {

/// A product of positive degrees stays above zero; otherwise a rule that fires would be lost.
double positive_product(double a, double b) {
  const double product = a * b;
  return product > 0.0 || a == 0.0 || b == 0.0 ? product : std::numeric_limits<double>::min();
}

/// Powers of positive degrees stay above zero, too.
double hedged_above_zero(double degree, const Target& target) {
  return std::max(hedged(degree, target.hedges), std::numeric_limits<double>::min());
}

double evaluate_condition(const CompiledRule& rule, const double* leaves, double* stack) {
  if (rule.all_min) {
    double degree = 1.0;
    for (const Instruction& instruction : rule.condition) {
      if (instruction.op == Operator::leaf) {
        degree = std::min(degree, leaves[instruction.argument]);
      }
    }
    return degree;
  }
  double* top = stack;
  for (const Instruction& instruction : rule.condition) {
    if (instruction.op == Operator::leaf) {
      *top++ = leaves[instruction.argument];
      continue;
    }
    top -= instruction.argument;
    double degree = top[0];
    for (std::size_t i = 1; i < instruction.argument; ++i) {
      degree = combine(instruction.op, degree, top[i]);
    }
    *top++ = degree;
  }
  return stack[0];
}

}  // namespace

Leaf::Leaf(std::size_t input_index, const FuzzySet& set)
    : input(input_index), first(set.points.front().degree), last(set.points.back().degree) {
  for (const FuzzySet::Point& point : set.points) {
    if (knots.empty() || knots.back().x != point.x) {
      knots.push_back({point.x, set.degree(point.x), point.x, last, 0.0, 1.0});
    }
  }
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    Knot& knot = knots[i];
    const double x1 = knots[i + 1].x;
    const double y0 = degree_after(set, knot.x);
    const double y1 = degree_before(set, x1);
    knot.slope = (y1 - y0) / (x1 - knot.x);
    knot.anchor_x = y0 <= y1 ? knot.x : x1;
    knot.anchor_degree = std::min(y0, y1);
    knot.cap = std::max(y0, y1);
  }
}

double Leaf::degree(double x) const {
  if (x < knots.front().x) {
    return first;
  }
  constexpr std::size_t kFew = 8;
  std::size_t i = 0;
  if (knots.size() <= kFew) {
    while (i + 1 < knots.size() && knots[i + 1].x <= x) {
      ++i;
    }
  } else {
    const auto right = std::upper_bound(knots.begin(), knots.end(), x,
                                        [](double v, const Knot& knot) { return v < knot.x; });
    i = static_cast<std::size_t>(right - knots.begin()) - 1;
  }
  const Knot& knot = knots[i];
  if (knot.x == x) {
    return knot.degree;
  }
  if (i + 1 == knots.size()) {
    return last;
  }
  return knot.line(x);
}

double Leaf::after(double x) const {
  if (x < knots.front().x) {
    return first;
  }
  const auto right = std::upper_bound(knots.begin(), knots.end(), x,
                                      [](double v, const Knot& knot) { return v < knot.x; });
  return right == knots.end() ? last : (right - 1)->line(x);
}

double Leaf::before(double x) const {
  const auto right = std::lower_bound(knots.begin(), knots.end(), x,
                                      [](const Knot& knot, double v) { return knot.x < v; });
  return right == knots.begin() ? first : right == knots.end() ? last : (right - 1)->line(x);
}

double combine(Operator op, double a, double b) {
  switch (op) {
    case Operator::min:
      return std::min(a, b);
    case Operator::product:
      return positive_product(a, b);
    case Operator::bounded_difference:
      return std::max(0.0, a + b - 1.0);
    case Operator::max:
      return std::max(a, b);
    case Operator::algebraic_sum:
      return std::min(1.0, a + b * (1.0 - a));
    case Operator::bounded_sum:
      return std::min(1.0, a + b);
    case Operator::leaf:
      break;
  }
  return 0.0;
}

void fire_rules(const ModelData& model, Workspace::Memory& memory) {
  for (std::size_t i = 0; i < model.leaves.size(); ++i) {
    const Leaf& leaf = model.leaves[i];
    memory.leaves[i] = leaf.degree(memory.inputs[leaf.input]);
  }
  std::fill(memory.slots.begin(), memory.slots.end(), 0.0);
  for (std::size_t r = 0; r < model.compiled_rules.size(); ++r) {
    const CompiledRule& rule = model.compiled_rules[r];
    double degree = evaluate_condition(rule, memory.leaves.data(), memory.stack.data());
    if (rule.weight != 1.0) {
      degree = positive_product(degree, rule.weight);
    }
    memory.degrees[r] = degree;
    if (degree <= 0.0) {
      continue;
    }
    for (const Target& target : rule.targets) {
      const double arrives = target.hedges.empty() ? degree : hedged_above_zero(degree, target);
      double& slot = memory.slots[target.slot];
      slot = model.outputs[target.output].accumulation == Accumulation::max
                 ? std::max(slot, arrives)
                 : slot + arrives;
    }
  }
}

}  // namespace elsie::fuzzy

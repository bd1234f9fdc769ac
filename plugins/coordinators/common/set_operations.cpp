#include "set_operations.h"

#include <algorithm>

#include <elsie/fuzzy/sets.h>

using elsie::FuzzySet;
namespace fuzzy = elsie::fuzzy;

SetOperator set_operator_of(const std::string& name) {
  return name == "probabilistic_sum" ? SetOperator::probabilistic_sum
         : name == "bounded_sum"     ? SetOperator::bounded_sum
         : name == "min"             ? SetOperator::minimum
         : name == "product"         ? SetOperator::product
         : name == "bounded_product" ? SetOperator::bounded_product
                                     : SetOperator::maximum;
}

bool unites(SetOperator by) {
  return by == SetOperator::maximum || by == SetOperator::probabilistic_sum ||
         by == SetOperator::bounded_sum;
}

double weighted(double degree, double weight, bool clip, SetOperator by) {
  if (unites(by)) {
    return clip ? std::min(weight, degree) : weight * degree;
  }
  return clip ? std::max(1.0 - weight, degree) : 1.0 - weight * (1.0 - degree);
}

FuzzySet weighted(const FuzzySet& set, double weight, bool clip, SetOperator by) {
  if (weight >= 1.0) {
    return set;
  }
  const FuzzySet& light = unites(by) ? set : fuzzy::complement_of(set);
  const FuzzySet result = clip ? fuzzy::clipped(light, weight) : fuzzy::scaled(light, weight);
  return unites(by) ? result : fuzzy::complement_of(result);
}

double combined(double a, double b, SetOperator by) {
  switch (by) {
    case SetOperator::maximum:
      return std::max(a, b);
    case SetOperator::probabilistic_sum:
      return a + b - a * b;
    case SetOperator::bounded_sum:
      return std::min(1.0, a + b);
    case SetOperator::minimum:
      return std::min(a, b);
    case SetOperator::product:
      return a * b;
    case SetOperator::bounded_product:
      return std::max(0.0, a + b - 1.0);
  }
  return 0.0;
}

FuzzySet combined(const FuzzySet& a, const FuzzySet& b, SetOperator by) {
  switch (by) {
    case SetOperator::maximum:
      return fuzzy::union_of(a, b);
    case SetOperator::probabilistic_sum:
      return fuzzy::algebraic_sum_of(a, b);
    case SetOperator::bounded_sum:
      return fuzzy::bounded_sum_of(a, b);
    case SetOperator::minimum:
      return fuzzy::intersection_of(a, b);
    case SetOperator::product:
      return fuzzy::product_of(a, b);
    case SetOperator::bounded_product:
      return fuzzy::complement_of(
          fuzzy::bounded_sum_of(fuzzy::complement_of(a), fuzzy::complement_of(b)));
  }
  return {};
}

std::optional<double> centre_of_gravity(const FuzzySet& set) {
  const auto centre = fuzzy::centroid(set);
  return centre ? centre : fuzzy::defuzzify(set, fuzzy::Defuzzification::centroid_of_singletons);
}

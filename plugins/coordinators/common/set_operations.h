// Operators on degrees and fuzzy sets that a fusion chooses among.
#pragma once

#include <optional>
#include <string>

#include <elsie/base/fuzzy_set.h>

/// How degrees of membership are put together. The first three say OR: what one wishes is possible.
/// The others say AND: what one does not wish is impossible.
enum class SetOperator {
  maximum,
  probabilistic_sum,  // a + b - a b
  bounded_sum,        // min(1, a + b)
  minimum,
  product,
  bounded_product,  // max(0, a + b - 1)
};

SetOperator set_operator_of(const std::string& name);

/// Whether the operator says OR.
bool unites(SetOperator by);

/// A degree as it counts with a weight in [0, 1]. With OR a light wish is a low one: scaled, w a,
/// or clipped, min(w, a). With AND a light wish restricts little: 1 - w (1 - a), or max(1 - w, a)
/// (Yager, 1978). Weight 1 leaves a degree as it is, weight 0 makes it say nothing.
double weighted(double degree, double weight, bool clip, SetOperator by);
elsie::FuzzySet weighted(const elsie::FuzzySet& set, double weight, bool clip, SetOperator by);

double combined(double a, double b, SetOperator by);
elsie::FuzzySet combined(const elsie::FuzzySet& a, const elsie::FuzzySet& b, SetOperator by);

/// The centre of gravity; of a set of spikes, which has no area, the mean of their places weighted
/// with their degrees. None where the set is zero everywhere.
std::optional<double> centre_of_gravity(const elsie::FuzzySet& set);

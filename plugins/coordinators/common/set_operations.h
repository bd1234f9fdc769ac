// Operators on degrees and fuzzy sets, for fusion.
#pragma once

#include <optional>
#include <string>

#include <elsie/base/fuzzy_set.h>

/// Combines degrees of membership. The first three mean OR: what one behaviour wishes is possible.
/// The others mean AND: what one behaviour does not wish is impossible.
enum class SetOperator {
  maximum,
  probabilistic_sum,  // a + b - a b
  bounded_sum,        // min(1, a + b)
  minimum,
  product,
  bounded_product,  // max(0, a + b - 1)
};

SetOperator set_operator_of(const std::string& name);

/// True if the operator means OR.
bool unites(SetOperator by);

/// A degree with a weight in [0, 1]. With OR, a small weight lowers a degree: scaled, w a, or
/// clipped, min(w, a). With AND, a small weight restricts less: 1 - w (1 - a), or max(1 - w, a)
/// (Yager, 1978). Weight 1 leaves a degree unchanged, weight 0 removes its influence.
double weighted(double degree, double weight, bool clip, SetOperator by);
elsie::FuzzySet weighted(const elsie::FuzzySet& set, double weight, bool clip, SetOperator by);

double combined(double a, double b, SetOperator by);
elsie::FuzzySet combined(const elsie::FuzzySet& a, const elsie::FuzzySet& b, SetOperator by);

/// The centre of gravity; for a set of spikes, which has no area, the mean of their positions
/// weighted with their degrees. None if the set is zero everywhere.
std::optional<double> centre_of_gravity(const elsie::FuzzySet& set);

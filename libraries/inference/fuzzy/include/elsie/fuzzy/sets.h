// Operations on fuzzy sets, the building blocks of fuzzy command fusion. All are exact on the
// straight lines of a set unless noted.
//
// A set continues to both sides with its last degree. Measures (area, centroid...) cover it from
// its first point to its last.
#pragma once

#include <optional>
#include <span>

#include "elsie/base/fuzzy_set.h"
#include "elsie/fuzzy/model.h"

namespace elsie::fuzzy {

/// The integral over the set.
double area(const FuzzySet& set);
/// The highest degree.
double height(const FuzzySet& set);
/// The centre of gravity; none when the set has no area.
std::optional<double> centroid(const FuzzySet& set);
/// The x that halves the area; if that is a gap, its middle. None when the set has no area.
std::optional<double> bisector(const FuzzySet& set);
/// The first and last x, and the mean of all x, at which the set is highest. If some of these are
/// plateaus, single peaks of the same height are left out of the mean. None when the set is zero
/// everywhere.
std::optional<double> leftmost_maximum(const FuzzySet& set);
std::optional<double> rightmost_maximum(const FuzzySet& set);
std::optional<double> mean_of_maxima(const FuzzySet& set);
/// Any of these methods by its name. centroid_of_singletons takes the points as singletons,
/// weighted by their degrees.
std::optional<double> defuzzify(const FuzzySet& set, Defuzzification method);

/// The larger degree at each x, over the extent of both.
FuzzySet union_of(const FuzzySet& a, const FuzzySet& b);
/// The smaller degree at each x.
FuzzySet intersection_of(const FuzzySet& a, const FuzzySet& b);
/// The sum of the degrees, at most 1.
FuzzySet bounded_sum_of(const FuzzySet& a, const FuzzySet& b);
/// a b and a + b - a b at each x. These are parabolas, given as straight lines within 2.5e-4.
FuzzySet product_of(const FuzzySet& a, const FuzzySet& b);
FuzzySet algebraic_sum_of(const FuzzySet& a, const FuzzySet& b);
/// weight_a a + weight_b b at each x; degrees may exceed 1, and the caller scales them.
FuzzySet weighted_sum_of(const FuzzySet& a, double weight_a, const FuzzySet& b, double weight_b);

/// Cut off at a degree: min(degree, set).
FuzzySet clipped(const FuzzySet& set, double degree);
/// All degrees times a factor in [0, 1].
FuzzySet scaled(const FuzzySet& set, double factor);
/// 1 - set.
FuzzySet complement_of(const FuzzySet& set);
/// The part between two x, with a point at each.
FuzzySet restricted(const FuzzySet& set, double low, double high);

/// The degree just left and just right of x; they differ at a step.
double degree_before(const FuzzySet& set, double x);
double degree_after(const FuzzySet& set, double x);

}  // namespace elsie::fuzzy

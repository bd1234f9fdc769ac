// Membership functions by the names that tools give them.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/base/fuzzy_set.h"
#include "elsie/fuzzy/model.h"

namespace elsie::fuzzy {

/// All names, for messages.
std::span<const std::string> shape_names();

/// The membership function of that name. Curves without end are drawn over the range; without one,
/// from and to where they have come within 1e-4 of their limit. Throws std::invalid_argument with a
/// sentence when there is no such shape or the parameters do not fit. Parameters may be infinite.
FuzzySet make_shape(std::string_view name, std::span<const double> parameters,
                    const std::optional<Range>& range);

/// The set of "very", "extremely very"... of what the set is of, the last word first: fuzzylite's
/// hedges, of a degree d: very d^2; extremely 2 d^2 up to d = 0.5, from there on 1 - 2 (1 - d)^2;
/// somewhat d^(1/2); seldom (d/2)^(1/2), then 1 - ((1 - d)/2)^(1/2).
FuzzySet hedged(const FuzzySet& set, std::string_view hedges);
/// The same of a degree.
double hedged(double degree, std::string_view hedges);

/// Appends the straight lines that stand for the function between consecutive knots. The function
/// must be continuous, and smooth between knots.
void draw_curve(const std::function<double(double)>& function, std::span<const double> knots,
                std::vector<FuzzySet::Point>& points);

}  // namespace elsie::fuzzy

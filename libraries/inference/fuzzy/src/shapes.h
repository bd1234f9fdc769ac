// Membership functions by the names that tools use.
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

/// All names; for messages.
std::span<const std::string> shape_names();

/// The membership function of this name. Unlimited curves are drawn over the range; without a
/// range, up to where they are within 1e-4 of their limit. Throws std::invalid_argument with a
/// sentence when there is no such shape or the parameters do not fit. Parameters may be infinite.
FuzzySet make_shape(std::string_view name, std::span<const double> parameters,
                    const std::optional<Range>& range);

/// Where a triangle or trapezoid stands whose corners are all at one place.
std::optional<double> only_corner(std::string_view name, std::span<const double> parameters);

/// Applies hedges, "very" or "extremely very", to a set, the last word first. fuzzylite's hedges of
/// a degree d: very d^2; extremely 2 d^2 up to d = 0.5, then 1 - 2 (1 - d)^2; somewhat d^(1/2);
/// seldom (d/2)^(1/2), then 1 - ((1 - d)/2)^(1/2).
FuzzySet hedged(const FuzzySet& set, std::string_view hedges);
/// The same for a degree.
double hedged(double degree, std::string_view hedges);

/// Appends straight lines that replace the function between consecutive knots. The function must be
/// continuous, and smooth between knots.
void draw_curve(const std::function<double(double)>& function, std::span<const double> knots,
                std::vector<FuzzySet::Point>& points);

}  // namespace elsie::fuzzy

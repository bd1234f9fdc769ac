// Convex outlines of upright prisms: their corners, counter-clockwise, in the plane. Lengths in m.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "elsie/api/geometry.h"

namespace elsie {

using Corners = std::span<const Vector2>;

/// The least length of an edge, and of anything in a world.
inline constexpr double kLeastLength = 1e-4;

/// What is wrong with points as the outline of a prism, to follow its name: "is not convex: ...".
/// None if they go around it once, either way. `things`: what several of could have such a form.
std::optional<std::string> problem_of_outline(Corners points, const char* things = "prisms");
/// The corners of points without a problem, counter-clockwise, the center of area at the origin.
std::vector<Vector2> centered_outline(Corners points);
/// The area, m2; negative if the corners go clockwise.
double area_of(Corners corners);

/// Second moments of an outline's area about the origin, divided by the area, m2 (Steger 1996).
struct OutlineMoments {
  double xx = 0.0;  // of x x
  double yy = 0.0;
  double xy = 0.0;
};
OutlineMoments moments_of(Corners corners);

}  // namespace elsie

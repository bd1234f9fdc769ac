// Lines through points.
#pragma once

#include <vector>

#include "elsie/api/geometry.h"

namespace elsie::picture {

/// The line with fewer points, which stays within `tolerance` of those left out (Ramer 1972,
/// Douglas and Peucker 1973). First and last point stay. All points must be finite.
std::vector<Vector2> simplified(const std::vector<Vector2>& line, double tolerance);

/// The parts of a line between points that are not finite.
std::vector<std::vector<Vector2>> pieces(const std::vector<Vector2>& line);

}  // namespace elsie::picture

// Lines as SVG path data.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "elsie/api/geometry.h"

namespace elsie::report {

/// The line with fewer points, none of those left out farther than `tolerance` from it (Ramer 1972,
/// Douglas and Peucker 1973). First and last point stay. All points are finite.
std::vector<Vector2> simplified(const std::vector<Vector2>& line, double tolerance);

/// The pieces of a line between points that are not finite; pieces of one point are left out.
std::vector<std::vector<Vector2>> pieces(const std::vector<Vector2>& line);

/// "M10 20l3-4 5 6": coordinates rounded to whole numbers, steps of less than one left out.
std::string path_data(const std::vector<Vector2>& line);

/// A part of a whole in percent, "34.52%".
std::string percent(double part);

}  // namespace elsie::report

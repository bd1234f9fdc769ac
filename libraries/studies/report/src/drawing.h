// Lines as SVG path data.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "elsie/api/geometry.h"

namespace elsie::report {

/// The line with fewer points, which stays within `tolerance` of those left out (Ramer 1972,
/// Douglas and Peucker 1973). First and last point stay. All points must be finite.
std::vector<Vector2> simplified(const std::vector<Vector2>& line, double tolerance);

/// The parts of a line between points that are not finite; parts of one point are left out.
std::vector<std::vector<Vector2>> pieces(const std::vector<Vector2>& line);

/// "M10 20l3-4 5 6": coordinates rounded to whole numbers; steps shorter than one are left out.
std::string path_data(const std::vector<Vector2>& line);

/// A share in percent, "34.52%".
std::string percent(double part);

}  // namespace elsie::report

// Level sets of a field on a regular grid, by marching squares (Lorensen and Cline, 1987, in the
// plane).
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "elsie/api/geometry.h"

namespace elsie::picture {

/// Values at the grid points (column, row), row by row. NaN: the four cells around it are left out.
struct Grid {
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::span<const double> values;

  double at(std::size_t column, std::size_t row) const { return values[row * columns + column]; }
};

/// Polygons in grid coordinates that cover the region where the field is at least `level`;
/// neighbours share edges, so that filling all of them leaves no seams.
std::vector<std::vector<Vector2>> region_above(const Grid& grid, double level);

/// The border of that region inside of the grid, in pieces of one cell each.
std::vector<std::pair<Vector2, Vector2>> contour(const Grid& grid, double level);

}  // namespace elsie::picture

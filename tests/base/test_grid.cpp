#include <limits>

#include <catch2/catch.hpp>

#include "elsie/base/grid.h"

using elsie::base::Grid;

TEST_CASE("A grid finds what was put into the cells of a rectangle") {
  Grid grid(4.0, 4.0);
  const Grid::Block here = grid.block(0.9, 0.9, 1.1, 1.1), there = grid.block(-1.9, 0.0, -1.9, 0.0);
  grid.insert(7, here);
  grid.insert(8, there);
  CHECK(grid.cell(grid.column(1.0), grid.row(1.0)).front() == 7);
  CHECK(grid.cell(grid.column(-1.9), grid.row(0.0)).front() == 8);
  CHECK(grid.cell(grid.column(1.0), grid.row(-1.0)).empty());
  grid.erase(7, here);
  CHECK(grid.cell(grid.column(1.0), grid.row(1.0)).empty());
}

TEST_CASE("Whoever leaves the area of a grid is in its outermost cells") {
  Grid grid(2.0, 1.0);
  const double far = 1e300, nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(grid.block(far, far, far, far) ==
        Grid::Block{grid.columns() - 1, grid.rows() - 1, grid.columns() - 1, grid.rows() - 1});
  CHECK(grid.block(-far, -far, -far, -far) == Grid::Block{0, 0, 0, 0});
  CHECK(grid.column(nan) == 0);
}

TEST_CASE("A grid over a large arena has large cells") {
  const Grid grid(1e5, 10.0);
  CHECK(grid.columns() <= 200);
  CHECK(grid.rows() >= 1);
}

#include "isoband.h"

#include <array>
#include <cmath>

namespace elsie::picture {
namespace {

struct Cell {
  std::array<Vector2, 4> corners;
  std::array<double, 4> values{};
  bool known = true;
  int inside = 0;
};

Cell cell_at(const Grid& grid, std::size_t column, std::size_t row, double level) {
  Cell cell;
  constexpr std::array<std::array<std::size_t, 2>, 4> kAround = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t c = column + kAround[i][0], r = row + kAround[i][1];
    cell.corners[i] = {static_cast<double>(c), static_cast<double>(r)};
    cell.values[i] = grid.at(c, r);
    cell.known = cell.known && std::isfinite(cell.values[i]);
    cell.inside += cell.values[i] >= level ? 1 : 0;
  }
  return cell;
}

// The point of the level between two corners on different sides of it.
Vector2 crossing(const Cell& cell, std::size_t i, std::size_t j, double level) {
  const double part = (level - cell.values[i]) / (cell.values[j] - cell.values[i]);
  const Vector2& a = cell.corners[i];
  const Vector2& b = cell.corners[j];
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
}

bool is_in(const Cell& cell, std::size_t i, double level) { return cell.values[i] >= level; }

}  // namespace

std::vector<std::vector<Vector2>> region_above(const Grid& grid, double level) {
  std::vector<std::vector<Vector2>> polygons;
  for (std::size_t row = 0; row + 1 < grid.rows; ++row) {
    const double low = static_cast<double>(row), high = low + 1;
    // Cells that are wholly inside are joined to one rectangle, which keeps the file small.
    std::size_t run_start = 0;
    bool in_run = false;
    const auto end_run = [&](std::size_t column) {
      if (!in_run) return;
      const double a = static_cast<double>(run_start), b = static_cast<double>(column);
      polygons.push_back({{a, low}, {b, low}, {b, high}, {a, high}});
      in_run = false;
    };
    for (std::size_t column = 0; column + 1 < grid.columns; ++column) {
      const Cell cell = cell_at(grid, column, row, level);
      if (cell.known && cell.inside == 4) {
        if (!in_run) run_start = column;
        in_run = true;
        continue;
      }
      end_run(column);
      if (!cell.known || cell.inside == 0) continue;
      std::vector<Vector2> polygon;
      for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t j = (i + 1) % 4;
        if (is_in(cell, i, level)) polygon.push_back(cell.corners[i]);
        if (is_in(cell, i, level) != is_in(cell, j, level)) {
          polygon.push_back(crossing(cell, i, j, level));
        }
      }
      polygons.push_back(std::move(polygon));
    }
    end_run(grid.columns - 1);
  }
  return polygons;
}

std::vector<std::pair<Vector2, Vector2>> contour(const Grid& grid, double level) {
  std::vector<std::pair<Vector2, Vector2>> pieces;
  for (std::size_t row = 0; row + 1 < grid.rows; ++row) {
    for (std::size_t column = 0; column + 1 < grid.columns; ++column) {
      const Cell cell = cell_at(grid, column, row, level);
      if (!cell.known || cell.inside == 0 || cell.inside == 4) continue;
      // Each exit from the region is joined with the next entry, as in region_above().
      for (std::size_t i = 0; i < 4; ++i) {
        if (!is_in(cell, i, level) || is_in(cell, (i + 1) % 4, level)) continue;
        std::size_t k = (i + 1) % 4;
        while (!is_in(cell, (k + 1) % 4, level)) k = (k + 1) % 4;
        pieces.emplace_back(crossing(cell, i, (i + 1) % 4, level),
                            crossing(cell, k, (k + 1) % 4, level));
      }
    }
  }
  return pieces;
}

}  // namespace elsie::picture

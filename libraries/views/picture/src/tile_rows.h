// Rectangles for a grid of colours, in which neighbours of one colour are one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/picture/floor_tiles.h"

namespace elsie::picture {

/// `look_at(column, row)`: a tile with the look of a cell; rows from north to south. `size`: of the
/// grid around the origin, m.
template <class LookAt>
std::vector<FloorTile> rows_of_tiles(int columns, int rows, const Vector2& size,
                                     const LookAt& look_at) {
  std::vector<FloorTile> tiles;
  const auto x = [&](int column) { return size.x * (1.0 * column / columns - 0.5); };
  const auto y = [&](int row) { return size.y * (0.5 - 1.0 * row / rows); };
  std::size_t above = 0;  // the first tile of the row above
  for (int row = 0; row < rows; ++row) {
    const std::size_t first = tiles.size();
    for (int column = 0, next = 0; column < columns; column = next) {
      FloorTile tile = look_at(column, row);
      while (++next < columns && look_at(next, row).looks_like(tile)) {
      }
      tile.left = x(column), tile.right = x(next);
      tile.bottom = y(row + 1), tile.top = y(row);
      tiles.push_back(tile);
    }
    // A row like the one above makes that one higher.
    const bool is_like_it =
        row > 0 && std::equal(tiles.begin() + static_cast<std::ptrdiff_t>(above),
                              tiles.begin() + static_cast<std::ptrdiff_t>(first),
                              tiles.begin() + static_cast<std::ptrdiff_t>(first), tiles.end(),
                              [](const FloorTile& a, const FloorTile& b) {
                                return a.left == b.left && a.looks_like(b);
                              });
    if (is_like_it) {
      tiles.resize(first);
      for (std::size_t i = above; i < first; ++i) tiles[i].bottom = y(row + 1);
    } else {
      above = first;
    }
  }
  return tiles;
}

}  // namespace elsie::picture

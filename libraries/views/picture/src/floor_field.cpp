#include "elsie/picture/floor_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "elsie/simulation/simulation.h"

#include "tile_rows.h"

namespace elsie::picture {

double FloorField::solid() const {
  if (full) return *full;
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

std::vector<std::uint8_t> FloorField::opacities() const {
  constexpr double kShades = 32.0, kMostOpaque = 0.85 * 255.0;
  const double most = solid();
  std::vector<std::uint8_t> all(values.size(), 0);
  if (!(most > 0.0)) return all;
  std::transform(values.begin(), values.end(), all.begin(), [&](float value) {
    const double shade = std::round(kShades * std::min(1.0, value / most)) / kShades;
    return static_cast<std::uint8_t>(std::lround(kMostOpaque * shade));
  });
  return all;
}

FloorField floor_field(const simulation::FieldView& field, std::size_t most) {
  const auto& [columns, rows, length, width] = field.cells;
  FloorField made{field.description->id,   field.description->colour, field.description->full,
                  std::min(columns, most), std::min(rows, most),      {}};
  made.values.reserve(made.columns * made.rows);
  for (std::size_t row = 0; row < made.rows; ++row) {
    const std::size_t y0 = row * rows / made.rows, y1 = (row + 1) * rows / made.rows;
    for (std::size_t column = 0; column < made.columns; ++column) {
      const std::size_t x0 = column * columns / made.columns;
      const std::size_t x1 = (column + 1) * columns / made.columns;
      double sum = 0.0;
      for (std::size_t y = y0; y < y1; ++y) {
        for (std::size_t x = x0; x < x1; ++x) sum += field.value(x, y);
      }
      made.values.push_back(static_cast<float>(sum / static_cast<double>((x1 - x0) * (y1 - y0))));
    }
  }
  return made;
}

std::vector<FloorTile> field_tiles(const FloorField& field, const world::Arena& arena,
                                   std::size_t most) {
  const std::vector<std::uint8_t> opacities = field.opacities();
  const std::size_t columns = std::min(field.columns, most), rows = std::min(field.rows, most);
  const auto sampled = [](int index, std::size_t shown, std::size_t all) {
    return (2 * static_cast<std::size_t>(index) + 1) * all / (2 * shown);
  };
  const auto tile_at = [&](int column, int row) {
    const std::size_t from_south = field.rows - 1 - sampled(row, rows, field.rows);
    const std::size_t cell = from_south * field.columns + sampled(column, columns, field.columns);
    return FloorTile{.colour = field.colour, .opacity = opacities[cell]};
  };
  std::vector<FloorTile> tiles = rows_of_tiles(static_cast<int>(columns), static_cast<int>(rows),
                                               {arena.length, arena.width}, tile_at);
  std::erase_if(tiles, [](const FloorTile& tile) { return tile.opacity == 0; });
  return tiles;
}

}  // namespace elsie::picture

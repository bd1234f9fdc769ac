#include "elsie/picture/floor_tiles.h"

#include <algorithm>

#include "elsie/world/floor.h"

namespace elsie::picture {

std::vector<FloorTile> floor_tiles(const world::World& world, int most) {
  std::vector<FloorTile> tiles;
  if (!world.floor.pixels) return tiles;
  const Image& image = *world.floor.pixels;
  const Vector2 size = world::image_size(world);
  const int columns = std::min(image.width, most), rows = std::min(image.height, most);
  const auto colour_at = [&](int column, int row) {
    const std::uint8_t* const pixel = image.pixel((2 * column + 1) * image.width / (2 * columns),
                                                  (2 * row + 1) * image.height / (2 * rows));
    return Colour{pixel[0], pixel[1], pixel[2]};
  };
  const auto x = [&](int column) { return size.x * (1.0 * column / columns - 0.5); };
  const auto y = [&](int row) { return size.y * (0.5 - 1.0 * row / rows); };
  std::size_t above = 0;  // the first tile of the row above
  for (int row = 0; row < rows; ++row) {
    const std::size_t first = tiles.size();
    for (int column = 0, next = 0; column < columns; column = next) {
      const Colour colour = colour_at(column, row);
      while (++next < columns && colour_at(next, row) == colour) {
      }
      tiles.push_back({x(column), x(next), y(row + 1), y(row), colour});
    }
    // A row like the one above makes that one higher.
    const bool is_like_it =
        row > 0 && std::equal(tiles.begin() + static_cast<std::ptrdiff_t>(above),
                              tiles.begin() + static_cast<std::ptrdiff_t>(first),
                              tiles.begin() + static_cast<std::ptrdiff_t>(first), tiles.end(),
                              [](const FloorTile& a, const FloorTile& b) {
                                return a.left == b.left && a.colour == b.colour;
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

#include "elsie/picture/floor_tiles.h"

#include <algorithm>

#include "elsie/world/floor.h"

#include "tile_rows.h"

namespace elsie::picture {

std::vector<FloorTile> floor_tiles(const world::World& world, int most) {
  if (!world.floor.pixels) return {};
  const Image& image = *world.floor.pixels;
  const int columns = std::min(image.width, most), rows = std::min(image.height, most);
  return rows_of_tiles(columns, rows, world::image_size(world), [&](int column, int row) {
    const std::uint8_t* const pixel = image.pixel((2 * column + 1) * image.width / (2 * columns),
                                                  (2 * row + 1) * image.height / (2 * rows));
    return FloorTile{.colour = {pixel[0], pixel[1], pixel[2]}};
  });
}

}  // namespace elsie::picture

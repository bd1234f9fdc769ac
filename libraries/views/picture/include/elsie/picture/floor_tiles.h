// The image of a floor as coloured rectangles, for pictures and recordings.
#pragma once

#include <cstdint>
#include <vector>

#include "elsie/world/description.h"

namespace elsie::picture {

/// A rectangle of one colour on the floor, m.
struct FloorTile {
  double left = 0.0, right = 0.0, bottom = 0.0, top = 0.0;
  Colour colour;
  std::uint8_t opacity = 255;  // of 255

  bool looks_like(const FloorTile& other) const {
    return colour == other.colour && opacity == other.opacity;
  }
};

/// The image of a world's floor in at most `most` rows and columns, in which neighbours of one
/// colour are one tile. An image with more pixels is sampled. Empty: there is none.
std::vector<FloorTile> floor_tiles(const world::World& world, int most);

}  // namespace elsie::picture

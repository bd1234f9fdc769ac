// Where the pictures of many cameras lie in a larger one.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "elsie/render/scene.h"

namespace elsie::render {

/// A picture's place in an atlas: columns and rows of its first pixel.
struct Tile {
  int x = 0, y = 0;           // px
  int width = 0, height = 0;  // px
};

/// The tiles of as many views as fit, from the first one on.
struct Atlas {
  int width = 0, height = 0;  // px, of the part that is in use
  std::vector<Tile> tiles;
};

/// Lays the views' pictures in rows, one beside the other: the first one, and as many of the next
/// as fit into an atlas of reasonable size. No picture may be wider or higher than `largest`
/// pixels.
Atlas pack(std::span<const View> views, int largest);

}  // namespace elsie::render

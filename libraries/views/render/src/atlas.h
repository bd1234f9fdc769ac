// Arranges the pictures of many cameras in a larger one.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "elsie/render/scene.h"

namespace elsie::render {

/// A picture's place in an atlas: column and row of its first pixel.
struct Tile {
  int x = 0, y = 0;           // px
  int width = 0, height = 0;  // px
};

/// The tiles of the views that fit, from the first one on.
struct Atlas {
  int width = 0, height = 0;  // px, of the part in use
  std::vector<Tile> tiles;
};

/// Arranges the views' pictures in rows: the first one, and as many of the next as fit into an
/// atlas of reasonable size. No picture may be wider or higher than `largest` pixels.
Atlas pack(std::span<const View> views, int largest);

}  // namespace elsie::render

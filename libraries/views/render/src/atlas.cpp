#include "atlas.h"

#include <algorithm>

namespace elsie::render {
namespace {

// The largest width and height of an atlas, unless its first picture is larger.
constexpr int kReasonable = 2048;  // px

}  // namespace

Atlas pack(std::span<const View> views, int largest) {
  Atlas atlas;
  if (views.empty()) {
    return atlas;
  }
  const Camera& first = views.front().camera;
  const int room = std::min(largest, std::max({kReasonable, first.width, first.height}));
  int x = 0, y = 0, row_height = 0;
  for (const View& view : views) {
    const int width = view.camera.width, height = view.camera.height;
    if (width > room - x) {
      y += row_height;
      x = row_height = 0;
    }
    if (width > room || height > room - y) {
      break;
    }
    atlas.tiles.push_back({x, y, width, height});
    x += width;
    row_height = std::max(row_height, height);
    atlas.width = std::max(atlas.width, x);
    atlas.height = std::max(atlas.height, y + row_height);
  }
  return atlas;
}

}  // namespace elsie::render

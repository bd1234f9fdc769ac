// Shared by the tests of the renderer: taking pictures and finding objects in them.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "elsie/render/renderer.h"
#include "elsie/render/scene.h"

namespace elsie::render::test {

inline constexpr Colour kRed{220, 40, 30};
inline constexpr Colour kGreen{40, 200, 60};
inline constexpr Colour kBlue{30, 60, 220};

/// One renderer for all tests that need no other: it keeps nothing between pictures.
inline Renderer& renderer() {
  static Renderer one;
  return one;
}

inline std::vector<Image> take(const Scene& scene, const std::vector<View>& views,
                               Renderer& with = renderer()) {
  std::vector<Image> pictures(views.size());
  std::vector<Image*> places;
  for (Image& picture : pictures) {
    places.push_back(&picture);
  }
  with.render(scene, views, places);
  return pictures;
}

inline Image take(const Scene& scene, const View& view) {
  return take(scene, std::vector<View>{view}).front();
}

/// A camera of 100 x 100 pixels and 30 degrees at `origin`.
inline View view_from(const Vector3& origin, double yaw_deg = 0.0, double pitch_deg = 0.0,
                      const Camera& camera = {100, 100, radians(30.0)}) {
  return {Frame::turned(origin, radians(yaw_deg), radians(pitch_deg)), camera};
}

/// An upright cube with its middle at this point.
inline Box cube(const Vector3& middle, double edge, const Colour& colour) {
  Box box;
  box.frame.origin = middle - Vector3{0.0, 0.0, 0.5 * edge};
  box.size = {edge, edge, edge};
  box.colour = colour;
  return box;
}

inline Colour colour_at(const Image& picture, int column, int row) {
  const std::uint8_t* pixel = picture.pixel(column, row);
  return {pixel[0], pixel[1], pixel[2]};
}

/// Whether a pixel shows a surface of this colour, in any light.
inline bool shows(const Colour& pixel, const Colour& surface) {
  const double light = std::max({pixel.red, pixel.green, pixel.blue}) /
                       static_cast<double>(std::max({surface.red, surface.green, surface.blue}));
  return std::abs(pixel.red - light * surface.red) < 2.0 &&
         std::abs(pixel.green - light * surface.green) < 2.0 &&
         std::abs(pixel.blue - light * surface.blue) < 2.0;
}

/// The pixels of a picture that show a surface of one colour.
struct Patch {
  int area = 0;                    // px
  double column = 0.0, row = 0.0;  // centre of area
  int left = 0, right = 0;         // first and last column
  int top = 0, bottom = 0;         // likewise
};

inline Patch find(const Image& picture, const Colour& surface) {
  Patch patch;
  patch.left = picture.width;
  patch.top = picture.height;
  for (int row = 0; row < picture.height; ++row) {
    for (int column = 0; column < picture.width; ++column) {
      if (!shows(colour_at(picture, column, row), surface)) {
        continue;
      }
      ++patch.area;
      patch.column += column + 0.5;
      patch.row += row + 0.5;
      patch.left = std::min(patch.left, column);
      patch.right = std::max(patch.right, column);
      patch.top = std::min(patch.top, row);
      patch.bottom = std::max(patch.bottom, row);
    }
  }
  if (patch.area > 0) {
    patch.column /= patch.area;
    patch.row /= patch.area;
  }
  return patch;
}

/// The number of pixels that differ between two pictures of the same size.
inline int differing_pixels(const Image& a, const Image& b) {
  int count = 0;
  for (std::size_t i = 0; i + 2 < a.bytes.size(); i += 3) {
    count += !std::equal(a.bytes.begin() + static_cast<std::ptrdiff_t>(i),
                         a.bytes.begin() + static_cast<std::ptrdiff_t>(i) + 3,
                         b.bytes.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return count;
}

}  // namespace elsie::render::test

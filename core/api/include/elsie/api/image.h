// Cameras and their pictures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "elsie/api/geometry.h"

namespace elsie {

/// A colour in sRGB.
struct Colour {
  std::uint8_t red = 128, green = 128, blue = 128;

  friend bool operator==(const Colour&, const Colour&) = default;
};

/// A picture: rows from the top, pixels from the left, `channels` bytes each (3: red, green, blue;
/// 1: grey). Empty: no picture was taken.
struct Image {
  int width = 0;   // px
  int height = 0;  // px
  int channels = 3;
  std::vector<std::uint8_t> bytes;

  bool empty() const { return bytes.empty(); }
  const std::uint8_t* pixel(int column, int row) const {
    return bytes.data() + (static_cast<std::ptrdiff_t>(row) * width + column) * channels;
  }
};

/// A pinhole camera: it looks along its frame's forward axis. Pixels are square, which determines
/// the vertical field of view. A point at an angle a to the left of the axis, in the plane of
/// forward and left, appears at the column width / 2 - (width / 2) tan(a) / tan(fov / 2), counted
/// from the left edge of the picture; the first pixel spans the columns from 0 to 1.
struct Camera {
  int width = 100;                  // px
  int height = 100;                 // px
  double horizontal_fov_rad = 0.0;  // the full angle, in (0, pi)
};

}  // namespace elsie

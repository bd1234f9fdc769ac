// Shared by the tests of pictures: the pixels of a PNG file, and where a point of the world is.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include <cairo.h>

#include "elsie/api/geometry.h"

#include "folder.h"
#include "top_view_parts.h"

namespace elsie::picture::test {

using elsie::test::Folder;

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

struct Pixel {
  int red = 0, green = 0, blue = 0;

  bool reddish() const { return red > green + 60 && red > blue + 60; }
  bool bluish() const { return blue > red + 60; }
  bool greenish() const { return green > red + 30 && green > blue; }
  bool light() const { return red > 225 && green > 225 && blue > 225; }
  bool dark() const { return red < 110 && green < 110 && blue < 110; }
};

class Bitmap {
 public:
  explicit Bitmap(const std::filesystem::path& file)
      : surface_(cairo_image_surface_create_from_png(file.c_str())) {
    if (cairo_surface_status(surface_) != CAIRO_STATUS_SUCCESS) {
      throw std::runtime_error("not a PNG file: " + file.string());
    }
  }
  ~Bitmap() { cairo_surface_destroy(surface_); }
  Bitmap(const Bitmap&) = delete;
  Bitmap& operator=(const Bitmap&) = delete;

  int width() const { return cairo_image_surface_get_width(surface_); }
  int height() const { return cairo_image_surface_get_height(surface_); }

  /// The pixel at this point.
  Pixel at(const Vector2& point) const {
    const int x = static_cast<int>(point.x), y = static_cast<int>(point.y);
    if (x < 0 || y < 0 || x >= width() || y >= height()) throw std::out_of_range("pixel");
    const unsigned char* row =
        cairo_image_surface_get_data(surface_) + y * cairo_image_surface_get_stride(surface_);
    std::uint32_t value = 0;
    std::copy_n(row + 4 * x, 4, reinterpret_cast<unsigned char*>(&value));
    return {static_cast<int>((value >> 16U) & 0xffU), static_cast<int>((value >> 8U) & 0xffU),
            static_cast<int>(value & 0xffU)};
  }

  /// The number of pixels within `reach` of the point that satisfy the predicate.
  template <class Predicate>
  int count(const Vector2& around, int reach, Predicate predicate) const {
    int found = 0;
    for (int dy = -reach; dy <= reach; ++dy) {
      for (int dx = -reach; dx <= reach; ++dx) {
        found += predicate(at({around.x + dx, around.y + dy})) ? 1 : 0;
      }
    }
    return found;
  }

 private:
  cairo_surface_t* surface_;
};

/// Maps points of the world (m) to the picture of save_top_view(), in pixels from its upper left
/// corner.
inline PlaneMap top_view_map(const TopView& view, const Size& size = {}) {
  const Scene scene = complete(view);
  const Layout layout = lay_out(scene, legend_of(scene), size, zoom_for_width(size.width));
  PlaneMap map = layout.map;
  for (double* const part : {&map.scale_x, &map.scale_y, &map.origin_x, &map.origin_y}) {
    *part *= layout.zoom;
  }
  return map;
}

}  // namespace elsie::picture::test

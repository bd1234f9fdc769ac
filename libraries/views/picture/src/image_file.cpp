#include "elsie/picture/image_file.h"

#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>

#include <cairo.h>

#include "file.h"

namespace elsie::picture {
namespace {

struct SurfaceDeleter {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, SurfaceDeleter>;

cairo_status_t append_bytes(void* sink, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(sink)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void check(const Image& image) {
  const bool channels = image.channels == 1 || image.channels == 3;
  const bool size = image.width > 0 && image.height > 0;
  if (channels && size &&
      image.bytes.size() == static_cast<std::size_t>(image.width) *
                                static_cast<std::size_t>(image.height) *
                                static_cast<std::size_t>(image.channels)) {
    return;
  }
  throw std::invalid_argument("An image of " + std::to_string(image.width) + " x " +
                              std::to_string(image.height) + " pixels with " +
                              std::to_string(image.channels) + " channels and " +
                              std::to_string(image.bytes.size()) +
                              " bytes cannot be written: it must hold width x height pixels of one "
                              "channel or of three.");
}

void check_written(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error(std::string("The image could not be written: ") +
                             cairo_status_to_string(status) + ".");
  }
}

Surface surface_of(const Image& image) {
  const bool grey = image.channels == 1;
  Surface surface(cairo_image_surface_create(grey ? CAIRO_FORMAT_A8 : CAIRO_FORMAT_RGB24,
                                             image.width, image.height));
  check_written(cairo_surface_status(surface.get()));
  unsigned char* const rows = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int row = 0; row < image.height; ++row) {
    unsigned char* to = rows + static_cast<std::ptrdiff_t>(row) * stride;
    const std::uint8_t* from = image.pixel(0, row);
    if (grey) {
      std::memcpy(to, from, static_cast<std::size_t>(image.width));
      continue;
    }
    for (int column = 0; column < image.width; ++column, from += 3, to += 4) {
      const std::uint32_t pixel = (static_cast<std::uint32_t>(from[0]) << 16U) |
                                  (static_cast<std::uint32_t>(from[1]) << 8U) | from[2];
      std::memcpy(to, &pixel, sizeof(pixel));
    }
  }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

}  // namespace

std::string png(const Image& image) {
  check(image);
  const Surface surface = surface_of(image);
  std::string content;
  check_written(cairo_surface_write_to_png_stream(surface.get(), append_bytes, &content));
  return content;
}

void write_png(const Image& image, const std::filesystem::path& file) {
  write_whole(file, png(image));
}

}  // namespace elsie::picture

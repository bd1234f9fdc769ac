// Reads PNG and PGM images; see elsie/world/images.h.
#include "elsie/world/images.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <stdexcept>

#include <png.h>

namespace elsie::images {
namespace {

[[noreturn]] void fail(const std::string& message) { throw std::runtime_error(message); }

bool is_size(std::size_t width, std::size_t height) {
  return width > 0 && height > 0 && width <= world::kMostPixels / height;
}

void check_size(std::size_t width, std::size_t height) {
  if (!is_size(width, height)) {
    fail("has " + std::to_string(width) + " x " + std::to_string(height) +
         " pixels; expected at least one, and at most " + std::to_string(world::kMostPixels));
  }
}

Image blank(std::size_t width, std::size_t height, int channels) {
  Image image{static_cast<int>(width), static_cast<int>(height), channels, {}};
  image.bytes.resize(width * height * static_cast<std::size_t>(channels));
  return image;
}

Image read_png(const std::string& content, int channels) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&png, content.data(), content.size()) != 0) {
    const std::size_t width = png.width, height = png.height;
    if (is_size(width, height)) {
      png.format = channels == 1 ? PNG_FORMAT_GRAY : PNG_FORMAT_RGB;
      Image image = blank(width, height, channels);
      const png_color white{255, 255, 255};
      if (png_image_finish_read(&png, &white, image.bytes.data(), 0, nullptr) != 0) return image;
    } else {
      png_image_free(&png);
      check_size(width, height);
    }
  }
  const std::string message = png.message;
  png_image_free(&png);
  fail("is no whole PNG image: " + message);
}

/// The numbers of a PGM's head and, if it is plain, of its pixels.
class Numbers {
 public:
  explicit Numbers(const std::string& content) : content_(content) {}

  std::size_t next() {
    while (at_ < content_.size()) {
      if (content_[at_] == '#') {
        at_ = std::min(content_.find('\n', at_), content_.size());
      } else if (content_[at_] == ' ' || (content_[at_] >= '\t' && content_[at_] <= '\r')) {
        ++at_;
      } else {
        break;
      }
    }
    std::size_t number = 0;
    const auto [end, error] =
        std::from_chars(content_.data() + at_, content_.data() + content_.size(), number);
    if (error != std::errc()) {
      fail("is no whole PGM image: expected a number at byte " + std::to_string(at_ + 1));
    }
    at_ = static_cast<std::size_t>(end - content_.data());
    return number;
  }
  /// After the one blank that ends the head.
  std::size_t begin_of_pixels() const { return at_ + 1; }

 private:
  const std::string& content_;
  std::size_t at_ = 2;  // after "P2" or "P5"
};

Image read_pgm(const std::string& content, int channels) {
  Numbers numbers(content);
  const std::size_t width = numbers.next();
  const std::size_t height = numbers.next();
  check_size(width, height);
  const std::size_t most = numbers.next();
  if (most == 0 || most > 255) {
    fail("is a PGM image with " + std::to_string(most) + " as its white; expected 1 to 255");
  }
  const std::size_t count = width * height;
  const bool is_plain = content[1] == '2';
  if (!is_plain && content.size() - std::min(content.size(), numbers.begin_of_pixels()) < count) {
    fail("is no whole PGM image: it has fewer bytes than its " + std::to_string(count) + " pixels");
  }
  const std::size_t begin = numbers.begin_of_pixels();
  Image image = blank(width, height, channels);
  auto byte = image.bytes.begin();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t value =
        is_plain ? numbers.next() : static_cast<unsigned char>(content[begin + i]);
    byte =
        std::fill_n(byte, channels, static_cast<std::uint8_t>(std::min(value, most) * 255 / most));
  }
  return image;
}

}  // namespace
}  // namespace elsie::images

extern "C" __attribute__((visibility("default"))) elsie::Image elsie_read_image(
    const std::string& content, int channels) {
  return content.starts_with("P") ? elsie::images::read_pgm(content, channels)
                                  : elsie::images::read_png(content, channels);
}

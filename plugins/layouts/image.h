// Images of floor plans: PNG, and PGM.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace elsie::layouts {

struct GreyImage {
  std::size_t width = 0, height = 0;
  std::vector<std::uint8_t> pixels;  // rows from the top; 0 is black, 255 white

  std::uint8_t at(std::size_t x, std::size_t y) const { return pixels[y * width + x]; }
};

/// The most pixels of an image.
inline constexpr std::size_t kMostPixels = 16'000'000;

bool is_image(const std::string& content);
/// Colours become grey; transparent pixels become white. Throws std::runtime_error with the end of
/// a sentence: "is no whole PNG image: ...".
GreyImage read_image(const std::string& content);

}  // namespace elsie::layouts

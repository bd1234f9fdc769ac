#include "colour_range.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace vision {
namespace {

// If the channels differ by less than this, rounding turns the hue of a colour in the shade by more
// than a few degrees.
constexpr int kLeastChroma = 24;

// The brightest grey of floor, walls and sky.
constexpr double kBrightestSurroundings = 140.0;

// The error of saturation and value by rounding of a channel.
constexpr double kRounding = 2.0;

struct Hsv {
  double hue_deg, saturation, value;  // both from 0 to 255
  int chroma;
};

/// The usual hexcone (Smith 1978).
Hsv to_hsv(const elsie::Colour& c) {
  const int high = std::max({c.red, c.green, c.blue}), low = std::min({c.red, c.green, c.blue});
  const int chroma = high - low;
  double hue = 0.0;
  if (chroma > 0) {
    const double d = chroma;
    hue = high == c.red     ? 60.0 * (c.green - c.blue) / d
          : high == c.green ? 120.0 + 60.0 * (c.blue - c.red) / d
                            : 240.0 + 60.0 * (c.red - c.green) / d;
  }
  return {hue, high > 0 ? 255.0 * chroma / high : 0.0, static_cast<double>(high), chroma};
}

std::string text(const elsie::Colour& c) {
  char buffer[8];
  std::snprintf(buffer, sizeof(buffer), "#%02x%02x%02x", c.red, c.green, c.blue);
  return buffer;
}

}  // namespace

std::vector<HsvRange> hsv_ranges(double hue_low, double hue_high, const cv::Scalar& low,
                                 const cv::Scalar& high) {
  const auto range = [&](double from, double to) {
    return HsvRange{{from, low[1], low[2]}, {to, high[1], high[2]}};
  };
  if (hue_low <= hue_high) {
    return {range(hue_low, hue_high)};
  }
  return {range(hue_low, 180.0), range(0.0, hue_high)};
}

std::vector<HsvRange> ranges_of(std::span<const elsie::Colour> colours, const MatchColour& step) {
  std::vector<HsvRange> all;
  for (const elsie::Colour& colour : colours) {
    const Hsv hsv = to_hsv(colour);
    const bool grey = hsv.chroma < kLeastChroma;
    const double slack = 255.0 * step.saturation_tolerance + kRounding;
    cv::Scalar low{0.0, hsv.saturation - slack, step.darkest * hsv.value - kRounding};
    const cv::Scalar high{180.0, hsv.saturation + slack, hsv.value + kRounding};
    if (grey && low[2] <= kBrightestSurroundings) {
      throw std::invalid_argument(
          "it cannot look for the colour " + text(colour) +
          ", a grey like those of floor, walls and sky; give the objects to find a colour with a "
          "hue, or white (the resource, or its team), or give the sensor a pipeline of its own");
    }
    if (!grey) {
      // Otherwise a pale red would include greys, to which OpenCV gives the hue of red.
      low[1] = std::max(low[1], 0.5 * hsv.saturation);
    }
    // In half degrees, modulo 180.
    const auto wrapped = [](double hue) { return hue - 180.0 * std::floor(hue / 180.0); };
    const double from = std::floor(0.5 * (hsv.hue_deg - step.hue_tolerance_deg));
    const double to = std::ceil(0.5 * (hsv.hue_deg + step.hue_tolerance_deg));
    if (grey || to - from >= 180.0) {  // the full circle or more
      all.push_back({low, high});
      continue;
    }
    const auto some = hsv_ranges(wrapped(from), wrapped(to), low, high);
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

std::vector<elsie::Colour> parse_colours(std::string_view text) {
  std::vector<elsie::Colour> colours;
  const std::string all(text);
  for (std::size_t at = text.find_first_not_of(' '); at != text.npos;
       at = text.find_first_not_of(' ', at)) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string_view word = text.substr(at, end - at);
    unsigned value = 0;
    const auto [stop, error] =
        std::from_chars(word.data() + 1, word.data() + word.size(), value, 16);
    if (word.size() != 7 || word[0] != '#' || error != std::errc() ||
        stop != word.data() + word.size()) {
      throw std::invalid_argument("colours is '" + all + "', in which '" + std::string(word) +
                                  "' is not a colour like '#d03030'; write colours with spaces "
                                  "between them");
    }
    colours.push_back({static_cast<std::uint8_t>(value >> 16U),
                       static_cast<std::uint8_t>(value >> 8U & 0xffU),
                       static_cast<std::uint8_t>(value & 0xffU)});
    at = end;
  }
  return colours;
}

}  // namespace vision

// Colours of the pictures: safe for colour-blind readers unless users choose them.
#pragma once

#include <cstddef>

#include "elsie/world/description.h"

namespace elsie::picture {

struct Ink {
  double red = 0.0, green = 0.0, blue = 0.0;  // in [0, 1], sRGB
  double alpha = 1.0;
  const char* role = nullptr;  // its name in the style of a page, where it follows light and dark

  Ink with_alpha(double new_alpha) const { return {red, green, blue, new_alpha, role}; }
};

constexpr Ink hex(unsigned rgb, const char* role = nullptr) {
  return {static_cast<double>((rgb >> 16U) & 0xffU) / 255.0,
          static_cast<double>((rgb >> 8U) & 0xffU) / 255.0,
          static_cast<double>(rgb & 0xffU) / 255.0, 1.0, role};
}

inline constexpr Ink kPaper = hex(0xffffff, "surface");
inline constexpr Ink kText = hex(0x22262b, "ink");
inline constexpr Ink kFaintText = hex(0x5c636b, "muted");
inline constexpr Ink kGrid = hex(0xe7e9ec, "grid");
inline constexpr Ink kFrame = hex(0x4a5058, "quiet");

Ink ink(const world::Colour& colour);
/// A mixture of a and b with this part of b, in [0, 1].
Ink mix(const Ink& a, const Ink& b, double part);
/// The colour turned and lightened in the OKLCH space (Ottosson, 2020), in which equal steps look
/// equal.
Ink shifted(const Ink& base, double lightness, double hue_rad);
/// The colour, darkened if necessary until it is readable as text on white.
Ink readable(const Ink& base);

/// The nth colour for curves (Okabe and Ito, 2008); they repeat after seven. In a page, they
/// are those of its style.
Ink series_ink(std::size_t index);
inline constexpr std::size_t kSeriesInks = 7;

/// The colour map "viridis" (Smith and van der Walt, 2015) at `part` in [0, 1].
Ink viridis(double part);

}  // namespace elsie::picture

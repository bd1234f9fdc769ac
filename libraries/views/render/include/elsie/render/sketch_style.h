// How what plugins draw looks in three dimensions, for each role: in the window and in run pages.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "elsie/api/image.h"
#include "elsie/api/sketch.h"

namespace elsie::render {

struct SketchStyle {
  Colour colour;
  double opacity;
  double width;       // px
  double dash = 0.0;  // px
};

inline constexpr SketchStyle kSketchStyles[] = {{{0x2a, 0x7a, 0xb8}, 0.45, 1.0},       // range
                                                {{0xc0, 0x30, 0x30}, 0.85, 1.2, 4.0},  // hit
                                                {{0x2f, 0x6f, 0x9f}, 0.35, 1.0},       // field
                                                {{0x1b, 0x5f, 0xb0}, 0.9, 1.4},        // target
                                                {{0x9c, 0x2f, 0x8a}, 0.9, 1.8},        // wish
                                                {{0x5a, 0x5f, 0x6b}, 0.9, 1.4, 2.0},   // belief
                                                {{0x00, 0x83, 0x8f}, 0.9, 1.6}};       // message

/// Of an unknown role, that of the last.
inline const SketchStyle& style_of(SketchRole role) {
  constexpr std::size_t kLast = std::size(kSketchStyles) - 1;
  return kSketchStyles[std::min(static_cast<std::size_t>(role), kLast)];
}

}  // namespace elsie::render

// Pictures of a scene for people: with a sky, shadows, materials, and lines over it.
//
//   renderer.compose(scene, view, style);
//   do {
//     renderer.expose(Shadows::soft, exposure);   // about as long as a picture of a camera takes
//   } while (exposure.passes() < kFinished);
//   exposure.develop(pixels);
//
// A pass draws the scene once. Each has its own small shift of the camera, its own point of the
// sun's disc and its own part of the sky; their mean has smooth edges, soft shadows and darker
// corners (Haeberli and Akeley 1990, the accumulation buffer). So the number of passes is the
// quality of a picture, and any number gives a whole one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/api/image.h"

namespace elsie::render {

/// The shadows of a pass.
enum class Shadows : std::uint8_t {
  none,
  hard,  // on the floor only, which costs little even without a graphics card
  sun,   // of everything on everything; the sky's only on the floor around things
  soft,  // of everything on everything, of sun and sky
};

/// What surrounds a scene in pictures for people.
struct Style {
  Vector2 arena;  // m: beyond it, the floor has the colour `outside`, and fades to the horizon
  Colour outside{204, 208, 212};
  Colour horizon{228, 233, 238};
  Colour zenith{176, 194, 214};
};

/// After as many passes a picture does not get much better.
inline constexpr int kFinished = 16;

/// A picture that is the mean of passes.
class Exposure {
 public:
  /// A new picture without passes.
  void begin(int width, int height);
  int width() const { return width_; }    // px
  int height() const { return height_; }  // px
  int passes() const { return passes_; }
  /// The pixels of a pass: red, green, blue, and how much of it is floor or sky.
  std::uint8_t* next() { return pass_.data(); }
  /// They have been filled.
  void add();
  /// Writes the mean: rows from the top, 0xAARRGGBB, where AA is 255 for floor and sky and 0 for
  /// what stands before them. Needs a pass.
  void develop(std::vector<std::uint32_t>& pixels) const;

 private:
  int width_ = 0, height_ = 0, passes_ = 0;
  std::vector<std::uint8_t> pass_, first_;
  std::vector<std::uint16_t> sums_;  // of more than one pass
};

}  // namespace elsie::render

// Pictures drawn by hand, for sensors with cameras.
#pragma once

#include "elsie/api/image.h"

namespace elsie::testing {

inline constexpr Colour kRed{220, 30, 30};
inline constexpr Colour kGreen{30, 200, 30};
inline constexpr Colour kBlue{30, 30, 220};
inline constexpr Colour kGrey{128, 128, 128};

/// A picture with three channels (red, green, blue). Columns and rows are counted from the upper
/// left corner, in pixels; a pixel is painted when its middle is inside of the shape. Shapes may
/// extend beyond the picture.
class Picture {
 public:
  explicit Picture(int width = 100, int height = 100, const Colour& background = kGrey);

  /// A disc with its middle at (column, row).
  Picture& disc(double column, double row, double radius, const Colour& colour = kRed);
  /// Paints a rectangle from one corner to the opposite one.
  Picture& rectangle(double left, double top, double right, double bottom,
                     const Colour& colour = kRed);

  const Image& image() const { return image_; }
  operator const Image&() const { return image_; }  // NOLINT(google-explicit-constructor)

 private:
  template <class Inside>
  Picture& paint(Inside inside, const Colour& colour);

  Image image_;
};

/// The mask of the pixels of exactly this colour: one channel, 255 for these pixels.
Image mask_of(const Image& picture, const Colour& colour);

}  // namespace elsie::testing

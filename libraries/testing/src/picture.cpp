#include "elsie/testing/picture.h"

#include <cmath>
#include <stdexcept>

namespace elsie::testing {

Picture::Picture(int width, int height, const Colour& background) {
  if (width < 1 || height < 1) {
    throw std::invalid_argument("a picture of " + std::to_string(width) + " x " +
                                std::to_string(height) + " pixels cannot be drawn");
  }
  image_.width = width;
  image_.height = height;
  image_.channels = 3;
  image_.bytes.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  paint([](double, double) { return true; }, background);
}

template <class Inside>
Picture& Picture::paint(Inside inside, const Colour& colour) {
  std::size_t at = 0;
  for (int row = 0; row < image_.height; ++row) {
    for (int column = 0; column < image_.width; ++column, at += 3) {
      if (inside(column + 0.5, row + 0.5)) {
        image_.bytes[at] = colour.red;
        image_.bytes[at + 1] = colour.green;
        image_.bytes[at + 2] = colour.blue;
      }
    }
  }
  return *this;
}

Picture& Picture::disc(double column, double row, double radius, const Colour& colour) {
  return paint([=](double x, double y) { return std::hypot(x - column, y - row) < radius; },
               colour);
}

Picture& Picture::rectangle(double left, double top, double right, double bottom,
                            const Colour& colour) {
  return paint([=](double x, double y) { return x > left && x < right && y > top && y < bottom; },
               colour);
}

Image mask_of(const Image& picture, const Colour& colour) {
  Image mask{picture.width, picture.height, 1, {}};
  mask.bytes.reserve(picture.bytes.size() / 3);
  for (std::size_t at = 0; at + 2 < picture.bytes.size(); at += 3) {
    const bool same = picture.bytes[at] == colour.red && picture.bytes[at + 1] == colour.green &&
                      picture.bytes[at + 2] == colour.blue;
    mask.bytes.push_back(same ? 255 : 0);
  }
  return mask;
}

}  // namespace elsie::testing

// The size of a picture file.
#pragma once

namespace elsie::picture {

/// In pixels (SVG: user units), each in [200, 16000]; anything else throws std::invalid_argument.
/// Text and lines grow with the width, so that a picture of 2000 pixels is the one of 1000 with
/// twice the resolution.
struct Size {
  int width = 1000;
  int height = 0;  // 0: what the content needs
};

}  // namespace elsie::picture

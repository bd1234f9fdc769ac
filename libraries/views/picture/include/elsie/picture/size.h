// The size of a picture file.
#pragma once

namespace elsie::picture {

/// In pixels (SVG: user units), each in [200, 16000]; others throw std::invalid_argument. Text and
/// lines grow with the width: a picture of 2000 pixels is that of 1000 at twice the resolution.
struct Size {
  int width = 1000;
  int height = 0;  // 0: as high as the content needs
};

}  // namespace elsie::picture

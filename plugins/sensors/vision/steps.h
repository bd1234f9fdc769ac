// The steps of a pipeline, as in a world file: from a camera's picture to a mask, and to one blob
// in it.
//
// Numbers are OpenCV's for pictures of 8 bits: every channel from 0 to 255, but hue (of hsv and
// hls) from 0 to 180, half a degree each.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace vision {

/// Converts to another colour space.
struct Convert {
  std::string to = "hsv";
};

/// Keeps pixels between two limits in every channel, both included. If the lower hue is above the
/// higher one, the range goes through red (0).
struct Threshold {
  std::vector<double> low{0.0, 0.0, 0.0};
  std::vector<double> high{255.0, 255.0, 255.0};
};

/// Keeps pixels of surfaces with given colours in any light.
struct MatchColour {
  std::string colours;                 // "#d03030 #3060d0"; empty: those of the robot's resources
  double hue_tolerance_deg = 10.0;     // to either side
  double saturation_tolerance = 0.25;  // likewise, relative to full saturation
  double darkest = 0.58;  // brightness of a face in the shade, relative to that in light
};

struct Blur {
  std::string kind = "gaussian";
  int size = 3;  // px
};

/// Morphology with a structuring element of this size and shape.
struct Morphology {
  int size = 3;  // px
  std::string shape = "square";
  int times = 1;
};
struct Erode : Morphology {};
struct Dilate : Morphology {};
struct Open : Morphology {};
struct Close : Morphology {};

/// The blob of the mask for the reading.
struct Blob {
  std::string choose = "largest";
  double min_area = 1.0;  // px; smaller blobs do not count
  double max_area = 0.0;  // px; 0: no limit
};

using Step = std::variant<Convert, Threshold, MatchColour, Blur, Erode, Dilate, Open, Close, Blob>;

}  // namespace vision

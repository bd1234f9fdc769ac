// The range of a surface's colour in OpenCV's HSV space, in any light.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include <opencv2/core.hpp>

#include <elsie/api/image.h>

#include "steps.h"

namespace vision {

/// A box in HSV: hue from 0 to 180, saturation and value from 0 to 255, limits included.
struct HsvRange {
  cv::Scalar low, high;
};

/// A range through hue 0 is divided in two.
std::vector<HsvRange> hsv_ranges(double hue_low, double hue_high, const cv::Scalar& low,
                                 const cv::Scalar& high);

/// The ranges of surfaces of these colours. White light keeps hue and saturation, so a colour with
/// a hue is recognised by both. A grey has no hue and is recognised by its brightness, which works
/// for white only, because floor, walls and sky are grey. Throws std::invalid_argument with a
/// sentence for a colour that cannot be distinguished from them.
std::vector<HsvRange> ranges_of(std::span<const elsie::Colour> colours, const MatchColour& step);

/// Colours like "#d03030 #3060d0". Throws std::invalid_argument.
std::vector<elsie::Colour> parse_colours(std::string_view text);

}  // namespace vision

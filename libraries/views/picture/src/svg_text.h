// Texts in an SVG as text elements; cairo writes outlines of letters, which cannot be searched or
// edited.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "elsie/api/geometry.h"

#include "canvas.h"

namespace elsie::picture {

/// Stores the texts of a drawing until its SVG is written. The drawing has a marker in place of
/// each text: a rectangle whose colour encodes the text's number, with an opacity that nothing else
/// has. So drawing covers and clips texts like everything else.
class SvgTexts {
 public:
  /// The opacity of the markers.
  static constexpr double kMarkerAlpha = 0.012345;

  /// Adds a text whose base line begins, is centred or ends at `at`; this, and the size of the
  /// style, are in pixels of the SVG. `drop`: the distance of the base line below the point around
  /// which it is turned. Returns the colour of its marker.
  Ink add(const std::string& text, const Vector2& at, double drop, const TextStyle& style);

  /// Replaces the markers by the texts. Markers are filled paths or rectangles of that opacity, in
  /// either form that versions of cairo write.
  void put_into(std::string& svg) const;

 private:
  std::vector<std::string> elements_;
};

}  // namespace elsie::picture

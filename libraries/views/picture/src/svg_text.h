// Text of an SVG as text: cairo writes outlines of letters, which nobody can search or edit.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "elsie/api/geometry.h"

#include "canvas.h"

namespace elsie::picture {

/// Keeps the texts of a drawing until its SVG is there. Where a text belongs, the drawing has a
/// marker: a rectangle in a colour that says which text it is, with an opacity that nothing else
/// has. So texts are covered and clipped by what cairo draws as any other part of the drawing.
class SvgTexts {
 public:
  /// The opacity of the markers.
  static constexpr double kMarkerAlpha = 0.012345;

  /// Adds a text whose base line begins, is centred or ends at `at`; both, and the size of the
  /// style, are in pixels of the SVG. `drop`: how far below the point around which it is turned
  /// the base line is. Returns the colour of its marker.
  Ink add(const std::string& text, const Vector2& at, double drop, const TextStyle& style);

  /// Puts the texts in the places of their markers: filled paths or rectangles of that opacity, in
  /// either of the forms that versions of cairo write.
  void put_into(std::string& svg) const;

 private:
  std::vector<std::string> elements_;
};

}  // namespace elsie::picture

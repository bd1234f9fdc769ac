// Symbols with what they mean, in rows.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "canvas.h"

namespace elsie::picture {

/// An entry of a legend: `draw` draws its symbol around the given point.
struct LegendEntry {
  std::string text;
  double width = 20.0;  // of the symbol
  std::function<void(Canvas&, const Vector2&)> draw;
};
/// The position of each entry, in units from the legend's upper left corner.
struct LegendLayout {
  std::vector<Vector2> places;
  double height = 0.0;
};
LegendLayout lay_out_legend(const Canvas& canvas, const std::vector<LegendEntry>& entries,
                            double width);
void draw_legend(Canvas& canvas, const std::vector<LegendEntry>& entries,
                 const LegendLayout& layout, const Vector2& corner);

}  // namespace elsie::picture

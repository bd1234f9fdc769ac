#include "legend.h"

#include "panel.h"

namespace elsie::picture {
namespace {

constexpr double kLine = 24.0;
constexpr double kBesideSymbol = 7.0;
constexpr double kGap = 24.0;
constexpr TextStyle kStyle{.size = 12.5, .down = Down::middle};

}  // namespace

LegendLayout lay_out_legend(const Canvas& canvas, const std::vector<LegendEntry>& entries,
                            double width) {
  LegendLayout layout;
  if (entries.empty()) return layout;
  Flow flow(width, kGap);
  for (const LegendEntry& entry : entries) {
    const double x =
        flow.place(entry.width + kBesideSymbol + canvas.text_width(entry.text, kStyle));
    layout.places.push_back({x, kLine * flow.row()});
  }
  layout.height = kLine * (flow.row() + 1) + 6;
  return layout;
}

void draw_legend(Canvas& canvas, const std::vector<LegendEntry>& entries,
                 const LegendLayout& layout, const Vector2& corner) {
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Vector2 at{corner.x + layout.places[i].x, corner.y + layout.places[i].y + kLine / 2};
    entries[i].draw(canvas, {at.x + entries[i].width / 2, at.y});
    canvas.text(entries[i].text, {at.x + entries[i].width + kBesideSymbol, at.y}, kStyle);
  }
}

}  // namespace elsie::picture

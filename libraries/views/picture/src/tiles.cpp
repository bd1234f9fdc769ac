// Two factors as coloured tiles.
#include <algorithm>
#include <cmath>

#include "panel.h"

namespace elsie::picture {
namespace {

// The names of the rows, shortened to a third of the picture.
Axis fitted_names(const Canvas& canvas, Axis axis, double width) {
  for (Tick& name : axis.names) name.text = canvas.fitted(name.text, {.size = kTick}, width / 3);
  return axis;
}

}  // namespace

void draw(Canvas& canvas, const Tiles& tiles, const Rect& area, double head) {
  Axis x = tiles.x;
  Axis y = fitted_names(canvas, tiles.y, area.width);
  const std::size_t columns = x.names.size(), rows = y.names.size();
  for (std::size_t i = 0; i < columns; ++i) x.names[i].at = static_cast<double>(i);
  for (std::size_t i = 0; i < rows; ++i) y.names[i].at = static_cast<double>(i);
  const Interval x_range{-0.5, static_cast<double>(columns) - 0.5};
  const Interval y_range{-0.5, static_cast<double>(rows) - 0.5};
  Interval values;
  for (const double value : tiles.values) values.include(value);
  const Interval z_range = interval_of(tiles.z, values.widened());

  constexpr double kBar = 14.0, kBarGap = 12.0;
  const double left = y_labels_width(canvas, y, y_range, area.height) + 32;
  const double right = kBarGap + kBar + 8 + y_labels_width(canvas, tiles.z, z_range, 8 * 45) + 26;
  const double width = std::max(10.0, area.width - left - right);
  const double below = 44 + (folds(canvas, x, x_range, width) ? kFold : 0.0);
  const Rect plot{area.x + left, area.y + head, width,
                  std::max(10.0, area.height - head - below)};
  const double tile_x = plot.width / static_cast<double>(columns);
  const double tile_y = plot.height / static_cast<double>(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const double value = tiles.values[row * columns + column];
      const Rect tile{plot.x + tile_x * static_cast<double>(column) + 1,
                      plot.bottom() - tile_y * static_cast<double>(row + 1) + 1, tile_x - 2,
                      tile_y - 2};
      const bool known = std::isfinite(value);
      const double part = known ? z_range.part(value) : 0.0;
      if (known) {
        canvas.rectangle(tile).fill(viridis(part));
      } else {
        draw_unknown(canvas, tile);
      }
      const TextStyle style{.size = kTick,
                            .ink = !known ? kText : part < 0.6 ? hex(0xffffff) : hex(0x16191d),
                            .across = Across::centre,
                            .down = Down::middle};
      const std::string& text = tiles.texts[row * columns + column];
      if (canvas.text_width(text, style) <= tile.width) canvas.text(text, tile.centre(), style);
    }
  }
  draw_axes(canvas, plot, x, x_range, y, y_range, false);
  if (!values.empty()) {
    draw_colour_bar(canvas, tiles.z, z_range, {plot.right() + kBarGap, plot.y, kBar, plot.height});
  }
  const TextStyle title{.size = kPanelTitle, .bold = true, .down = Down::top};
  canvas.text(canvas.fitted(tiles.title, title, area.width - left), {plot.x, area.y}, title);
}

}  // namespace elsie::picture

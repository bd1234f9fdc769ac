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

// Black or white, whichever has more contrast to the colour (WCAG 2.1): at least 4.5.
Ink text_on(const Ink& colour) {
  const auto linear = [](double part) {
    return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  };
  const double luminance =
      0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
  return luminance > 0.179 ? hex(0x000000) : hex(0xffffff);
}

// The borders of the tiles along an axis: halfway between names at ascending places; names at equal
// places are set apart.
std::vector<double> borders_of(Axis& axis) {
  auto& names = axis.names;
  bool apart = true;
  for (std::size_t i = 1; i < names.size(); ++i) apart = apart && names[i - 1].at < names[i].at;
  for (std::size_t i = 0; i < names.size() && !apart; ++i) names[i].at = static_cast<double>(i);
  std::vector<double> borders{0.0};
  for (std::size_t i = 1; i < names.size(); ++i) {
    borders.push_back(0.5 * (names[i - 1].at + names[i].at));
  }
  const bool single = names.size() == 1;
  borders[0] = names.front().at - (single ? 0.5 : borders[1] - names.front().at);
  borders.push_back(names.back().at + (single ? 0.5 : names.back().at - borders.back()));
  return borders;
}

}  // namespace

void draw(Canvas& canvas, const Tiles& tiles, const Rect& area, double head) {
  Axis x = tiles.x;
  Axis y = fitted_names(canvas, tiles.y, area.width);
  const std::size_t columns = x.names.size(), rows = y.names.size();
  const std::vector<double> across = borders_of(x), up = borders_of(y);
  const Interval x_range{across.front(), across.back()}, y_range{up.front(), up.back()};
  Interval values;
  for (const double value : tiles.values) values.include(value);
  const Interval z_range = interval_of(tiles.z, values.widened());

  constexpr double kBar = 14.0, kBarGap = 12.0, kLeastHeight = 18.0;
  const double left = y_labels_width(canvas, y, y_range, area.height) + 32;
  // Without room for the texts, a bar says what the colours mean.
  double widest = 0.0;
  for (const std::string& text : tiles.texts) {
    widest = std::max(widest, canvas.text_width(text, {.size = kTick}));
  }
  const auto narrowest = [](const std::vector<double>& borders) {
    double least = borders[1] - borders[0];
    for (std::size_t i = 2; i < borders.size(); ++i) {
      least = std::min(least, borders[i] - borders[i - 1]);
    }
    return least / (borders.back() - borders.front());
  };
  const bool readable = widest + 8 < (area.width - left) * narrowest(across) &&
                        (area.height - head - 60) * narrowest(up) > kLeastHeight;
  const double right =
      readable ? 10.0 : kBarGap + kBar + 8 + y_labels_width(canvas, tiles.z, z_range, 8 * 45) + 26;
  const double width = std::max(10.0, area.width - left - right);
  const double below = 44 + (folds(canvas, x, x_range, width) ? kFold : 0.0);
  const Rect plot{area.x + left, area.y + head, width, std::max(10.0, area.height - head - below)};
  const PlaneMap map = map_to(plot, x_range, y_range);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const double value = tiles.values[row * columns + column];
      const Vector2 from = map.pixel({across[column], up[row + 1]});
      const Vector2 to = map.pixel({across[column + 1], up[row]});
      const Rect tile{from.x + 1, from.y + 1, to.x - from.x - 2, to.y - from.y - 2};
      const bool known = std::isfinite(value);
      const double part = known ? z_range.part(value) : 0.0;
      if (known) {
        canvas.rectangle(tile).fill(viridis(part));
      } else {
        draw_unknown(canvas, tile);
      }
      const TextStyle style{.size = kTick,
                            .ink = known ? text_on(viridis(part)) : kText,
                            .across = Across::centre,
                            .down = Down::middle};
      const std::string& text = tiles.texts[row * columns + column];
      if (readable) canvas.text(text, tile.centre(), style);
    }
  }
  draw_axes(canvas, plot, x, x_range, y, y_range, false);
  if (!readable && !values.empty()) {
    draw_colour_bar(canvas, tiles.z, z_range, {plot.right() + kBarGap, plot.y, kBar, plot.height});
  }
  const TextStyle title{.size = kPanelTitle, .bold = true, .down = Down::top};
  canvas.text(canvas.fitted(tiles.title, title, area.width - left), {plot.x, area.y}, title);
}

}  // namespace elsie::picture

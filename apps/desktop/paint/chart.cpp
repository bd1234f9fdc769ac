#include "paint/chart.h"

#include <QImage>
#include <QPainter>
#include <QPalette>
#include <algorithm>

#include "paint/axes.h"

namespace elsie::desktop {
namespace {

constexpr double kLine = 15.0;  // units of the chart for a line of the window's text

Colour plain(const QColor& colour) {
  return {static_cast<std::uint8_t>(colour.red()), static_cast<std::uint8_t>(colour.green()),
          static_cast<std::uint8_t>(colour.blue())};
}

QColor mixed(const QColor& a, const QColor& b, float part) {
  return QColor::fromRgbF(a.redF() + part * (b.redF() - a.redF()),
                          a.greenF() + part * (b.greenF() - a.greenF()),
                          a.blueF() + part * (b.blueF() - a.blueF()));
}

picture::Style style_of(const QPalette& palette) {
  const QColor ink = palette.color(QPalette::Text), paper = palette.color(QPalette::Base);
  picture::Style style{{"surface", plain(paper)},
                       {"ink", plain(ink)},
                       {"muted", plain(mixed(ink, paper, 0.25F))},
                       {"quiet", plain(mixed(ink, paper, 0.25F))},
                       {"grid", plain(mixed(ink, paper, 0.85F))},
                       {"panel", plain(mixed(ink, paper, 0.93F))},
                       {"line", plain(mixed(ink, paper, 0.8F))}};
  for (int n = 0; n < 6; ++n) {
    style["c" + std::to_string(n)] = plain(curve_colour(n, palette));
  }
  return style;
}

}  // namespace

void draw_chart(QPainter& painter, const QRectF& area, const picture::Panel& panel,
                const QPalette& palette) {
  const double ratio = painter.device()->devicePixelRatioF();
  const QSize size = (ratio * area.size()).toSize().expandedTo({1, 1});
  const double zoom = ratio * painter.fontMetrics().height() / kLine;
  const std::vector<std::uint32_t> pixels =
      picture::screen_chart(panel, size.width(), size.height(), zoom, style_of(palette));
  QImage image(reinterpret_cast<const uchar*>(pixels.data()), size.width(), size.height(),
               QImage::Format_RGB32);
  image.setDevicePixelRatio(ratio);
  painter.drawImage(area.topLeft(), image);
}

}  // namespace elsie::desktop

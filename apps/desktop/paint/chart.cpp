#include "paint/chart.h"

#include <QFontMetrics>
#include <QImage>
#include <QPainter>
#include <QPalette>
#include <algorithm>

#include "paint/axes.h"

namespace elsie::desktop {
namespace {

Colour plain(const QColor& colour) {
  return {static_cast<std::uint8_t>(colour.red()), static_cast<std::uint8_t>(colour.green()),
          static_cast<std::uint8_t>(colour.blue())};
}

QColor mixed(const QColor& a, const QColor& b, float part) {
  return QColor::fromRgbF(a.redF() + part * (b.redF() - a.redF()),
                          a.greenF() + part * (b.greenF() - a.greenF()),
                          a.blueF() + part * (b.blueF() - a.blueF()));
}

}  // namespace

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
  if (paper.lightnessF() < 0.5F) {  // the nodes of graphs are pale otherwise
    style.insert({{"running", {0x7a, 0x5c, 0x00}},
                  {"within", {0x3d, 0x33, 0x14}},
                  {"success", {0x2f, 0x5c, 0x24}},
                  {"failure", {0x78, 0x30, 0x28}}});
  }
  return style;
}

void draw_pixels(
    QPainter& painter, const QRectF& area,
    const std::function<std::vector<std::uint32_t>(const QSize& size, double ratio)>& drawn) {
  const double ratio = painter.device()->devicePixelRatioF();
  const QSize size = (ratio * area.size()).toSize().expandedTo({1, 1});
  const std::vector<std::uint32_t> pixels = drawn(size, ratio);
  QImage image(reinterpret_cast<const uchar*>(pixels.data()), size.width(), size.height(),
               QImage::Format_RGB32);
  image.setDevicePixelRatio(ratio);
  painter.drawImage(area.topLeft(), image);
}

void draw_chart(QPainter& painter, const QRectF& area, const picture::Panel& panel,
                const QPalette& palette) {
  const double zoom = painter.fontMetrics().height() / kTextLine;
  draw_pixels(painter, area, [&](const QSize& size, double ratio) {
    return picture::screen_chart(panel, size.width(), size.height(), ratio * zoom,
                                 style_of(palette));
  });
}

PlotPlace plot_place(const QRectF& area, const picture::LineChart& chart,
                     const QFontMetrics& font) {
  constexpr int kFine = 16;  // parts of a pixel: a size is whole
  const QSize size = (kFine * area.size()).toSize();
  const picture::PlotPlace place =
      picture::screen_plot(chart, size.width(), size.height(), kFine * font.height() / kTextLine);
  const QRectF plot(place.across.low, place.down.low, place.across.span(), place.down.span());
  return {QRectF(area.topLeft() + plot.topLeft() / kFine, plot.size() / kFine),
          {place.x.low, place.x.high}};
}

}  // namespace elsie::desktop

// Charts of the picture library in a window.
#pragma once

#include <QRectF>
#include <QSize>
#include <cstdint>
#include <functional>
#include <vector>

#include "elsie/picture/plot.h"

#include "paint/axes.h"

class QFontMetrics;
class QPainter;
class QPalette;

namespace elsie::desktop {

/// Units of a picture for a line of the window's text.
inline constexpr double kTextLine = 15.0;

/// The palette's colours for pictures.
picture::Style style_of(const QPalette& palette);

/// Draws the pixels that `drawn` returns for an area of this size in pixels of the screen, of which
/// `ratio` make one of the window.
void draw_pixels(
    QPainter& painter, const QRectF& area,
    const std::function<std::vector<std::uint32_t>(const QSize& size, double ratio)>& drawn);

/// Draws a chart as elsie::picture draws it into files, in the palette's colours and the size of
/// the painter's font.
void draw_chart(QPainter& painter, const QRectF& area, const picture::Panel& panel,
                const QPalette& palette);

/// The plot of a chart that draw_chart() draws into this area, and the values of x at its sides.
struct PlotPlace {
  QRectF plot;
  Span x;
};
PlotPlace plot_place(const QRectF& area, const picture::LineChart& chart, const QFontMetrics& font);

}  // namespace elsie::desktop

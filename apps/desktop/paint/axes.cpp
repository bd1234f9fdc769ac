#include "paint/axes.h"

#include <QLocale>
#include <QPainter>
#include <QPalette>
#include <algorithm>
#include <array>
#include <cmath>

#include "elsie/picture/axis.h"

namespace elsie::desktop {

std::vector<double> ticks(const Span& span, int about) {
  return picture::nice_ticks(span.low, span.high, about).at;
}

QString number_text(double value) {
  return std::isfinite(value) ? QLocale::c().toString(value, 'g', 4) : QStringLiteral("-");
}

QColor curve_colour(int n, const QPalette& palette) {
  static constexpr std::array<QRgb, 7> kLight{0x0072b2, 0xb84a00, 0x00795a, 0xa0447c,
                                              0x8a6500, 0x2b7bb0, 0x333333};
  static constexpr std::array<QRgb, 7> kDark{0x4aa8e0, 0xff8b3d, 0x2fc79a, 0xe79ac4,
                                             0xf0c043, 0x8fd0f7, 0xdddddd};
  const bool dark = palette.color(QPalette::Base).lightnessF() < 0.5F;
  return QColor((dark ? kDark : kLight)[static_cast<std::size_t>(n) % kLight.size()]);
}

QColor red(const QPalette& palette) {
  const bool dark = palette.color(QPalette::Window).lightnessF() < 0.5F;
  return dark ? QColor(0xff, 0x9a, 0x90) : QColor(0xb0, 0x20, 0x20);
}

Qt::PenStyle pen_style(int n) {
  static constexpr std::array kStyles{Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
  return kStyles[static_cast<std::size_t>(n) % kStyles.size()];
}

Qt::BrushStyle hatch(int n) {
  static constexpr std::array kHatches{Qt::BDiagPattern, Qt::FDiagPattern, Qt::Dense4Pattern,
                                       Qt::HorPattern,   Qt::CrossPattern, Qt::VerPattern};
  return kHatches[static_cast<std::size_t>(n) % kHatches.size()];
}

Axes::Axes(QPainter& painter, const QRectF& whole, const Span& x, const Span& y) : x_(x), y_(y) {
  const QFontMetricsF font = painter.fontMetrics();
  double widest = font.horizontalAdvance(u'0') * 3;
  for (const double tick : ticks(y, 6)) {
    widest = std::max(widest, font.horizontalAdvance(number_text(tick)));
  }
  // Half of the last number below the axis may be outside.
  const double right = std::max(font.height(), font.horizontalAdvance(number_text(x.high)) * 0.6);
  area_ = whole.adjusted(widest + font.height() * 0.7, font.height() * 1.5, -right,
                         -font.height() * 2.6);
}

QPointF Axes::at(double x, double y) const {
  return {area_.left() + (x - x_.low) / x_.length() * area_.width(),
          area_.bottom() - (y - y_.low) / y_.length() * area_.height()};
}

void Axes::draw(QPainter& painter, const QPalette& palette, const QString& x_name,
                const QString& y_name) const {
  const QFontMetricsF font = painter.fontMetrics();
  const double line = font.height();
  QColor faint = palette.color(QPalette::Text);
  faint.setAlphaF(0.15F);
  const QColor ink = palette.color(QPalette::Text);
  for (const double tick : ticks(x_, std::max(2, static_cast<int>(area_.width() / (line * 4))))) {
    const double place = at(tick, y_.low).x();
    painter.setPen(faint);
    painter.drawLine(QPointF(place, area_.top()), QPointF(place, area_.bottom()));
    painter.setPen(ink);
    painter.drawText(QRectF(place - line * 4, area_.bottom() + line * 0.2, line * 8, line),
                     Qt::AlignHCenter | Qt::AlignTop, number_text(tick));
  }
  const int most = std::clamp(static_cast<int>(area_.height() / (line * 2)), 2, 6);
  for (const double tick : ticks(y_, most)) {
    const double place = at(x_.low, tick).y();
    painter.setPen(faint);
    painter.drawLine(QPointF(area_.left(), place), QPointF(area_.right(), place));
    painter.setPen(ink);
    painter.drawText(QRectF(area_.left() - line * 20, place - line, line * 19.6, line * 2),
                     Qt::AlignRight | Qt::AlignVCenter, number_text(tick));
  }
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(area_);
  painter.drawText(QRectF(area_.left(), area_.bottom() + line * 1.3, area_.width(), line * 1.2),
                   Qt::AlignHCenter | Qt::AlignTop,
                   font.elidedText(x_name, Qt::ElideRight, area_.width()));
  painter.drawText(QRectF(area_.left(), area_.top() - line * 1.4, area_.width(), line * 1.2),
                   Qt::AlignLeft | Qt::AlignVCenter,
                   font.elidedText(y_name, Qt::ElideRight, area_.width()));
}

void Axes::draw_curve(QPainter& painter, const QPolygonF& points, const QPen& pen) const {
  painter.save();
  painter.setClipRect(area_.adjusted(-1, -1, 1, 1));
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  QPolygonF piece;
  for (const QPointF& point : points) {
    if (std::isfinite(point.x()) && std::isfinite(point.y())) {
      piece << at(point.x(), point.y());
    } else {
      painter.drawPolyline(piece);
      piece.clear();
    }
  }
  painter.drawPolyline(piece);
  painter.restore();
}

}  // namespace elsie::desktop

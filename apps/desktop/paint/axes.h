// Axes, curves and colours of all plots of the desktop program.
#pragma once

#include <QColor>
#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <vector>

class QPainter;
class QPalette;

namespace elsie::desktop {

struct Span {
  double low = 0.0;
  double high = 1.0;

  double length() const { return high - low; }
};

/// Round numbers in the span, about so many: picture::nice_ticks().
std::vector<double> ticks(const Span& span, int about);
/// A number as on an axis, with a decimal point in every language.
QString number_text(double value);

/// The n-th colour of curves: readable on the palette's base, and distinct for the colour-blind
/// (Okabe and Ito, 2008). Curves differ in their dashes, too: pen_style().
QColor curve_colour(int n, const QPalette& palette);
Qt::PenStyle pen_style(int n);
/// The colour of errors, readable on the palette's window.
QColor red(const QPalette& palette);
/// A pattern in addition to the colour, for areas.
Qt::BrushStyle hatch(int n);

/// A rectangle with two axes.
class Axes {
 public:
  /// `whole` includes the room for numbers and names, which depends on the painter's font.
  Axes(QPainter& painter, const QRectF& whole, const Span& x, const Span& y);

  const QRectF& area() const { return area_; }
  QPointF at(double x, double y) const;
  /// Draws grid, frame, numbers and names in the palette's colours.
  void draw(QPainter& painter, const QPalette& palette, const QString& x_name,
            const QString& y_name) const;
  /// Draws a curve; values that are not finite interrupt it.
  void draw_curve(QPainter& painter, const QPolygonF& points, const QPen& pen) const;

 private:
  QRectF area_;
  Span x_;
  Span y_;
};

}  // namespace elsie::desktop

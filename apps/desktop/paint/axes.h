// Numbers and colours of all plots of the desktop program.
#pragma once

#include <QColor>
#include <QString>
#include <vector>

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
/// (Okabe and Ito, 2008).
QColor curve_colour(int n, const QPalette& palette);
/// The colour of errors, readable on the palette's window.
QColor red(const QPalette& palette);
/// A pattern in addition to the colour, for areas.
Qt::BrushStyle hatch(int n);

}  // namespace elsie::desktop

#include "paint/axes.h"

#include <QLocale>
#include <QPalette>
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

Qt::BrushStyle hatch(int n) {
  static constexpr std::array kHatches{Qt::BDiagPattern, Qt::FDiagPattern, Qt::Dense4Pattern,
                                       Qt::HorPattern,   Qt::CrossPattern, Qt::VerPattern};
  return kHatches[static_cast<std::size_t>(n) % kHatches.size()];
}

}  // namespace elsie::desktop

#include "paint/padlock.h"

#include <QPainter>
#include <QPixmap>

namespace elsie::desktop {

void draw_padlock(QPainter& painter, const QRectF& area, const QColor& colour) {
  const double w = area.width(), h = area.height();
  const QRectF body(area.left() + 0.14 * w, area.top() + 0.46 * h, 0.72 * w, 0.48 * h);
  const QRectF bow(area.left() + 0.28 * w, area.top() + 0.08 * h, 0.44 * w, 0.76 * h);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colour, 0.12 * w));
  painter.setBrush(Qt::NoBrush);
  painter.drawArc(bow, 0, 180 * 16);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawRoundedRect(body, 0.08 * w, 0.08 * w);
  painter.restore();
}

QIcon padlock_icon(const QColor& colour) {
  constexpr int kSide = 64;  // px; the style scales it
  QPixmap picture(kSide, kSide);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  draw_padlock(painter, QRectF(0.0, 0.0, kSide, kSide), colour);
  return QIcon(picture);
}

}  // namespace elsie::desktop

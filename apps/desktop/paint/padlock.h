// The mark of objects that are locked against the mouse.
#pragma once

#include <QColor>
#include <QIcon>

class QPainter;
class QRectF;

namespace elsie::desktop {

void draw_padlock(QPainter& painter, const QRectF& area, const QColor& colour);
QIcon padlock_icon(const QColor& colour);

}  // namespace elsie::desktop

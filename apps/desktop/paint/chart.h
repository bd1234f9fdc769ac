// Charts of the picture library in a window.
#pragma once

#include <QRectF>

#include "elsie/picture/plot.h"

class QPainter;
class QPalette;

namespace elsie::desktop {

/// Draws a chart as elsie::picture draws it into files, in the palette's colours and the size of
/// the painter's font.
void draw_chart(QPainter& painter, const QRectF& area, const picture::Panel& panel,
                const QPalette& palette);

}  // namespace elsie::desktop

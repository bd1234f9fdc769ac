// Names of robots over the view.
#pragma once

#include <QFontMetricsF>
#include <QRectF>
#include <QString>
#include <vector>

#include "scene/camera.h"
#include "scene/stage.h"

namespace elsie::desktop {

struct Label {
  QString text;
  QRectF box;  // px
};

/// A box with the text; `at`: its lower left corner.
QRectF label_box(const QFontMetricsF& metrics, const QPointF& at, const QString& text);

/// The names of the robots in a view of that size, none over another: each above its robot, or a
/// line higher or lower where another name is in the way. Those for which there is no room are left
/// out, the ones far from the camera first.
std::vector<Label> labels_of(const Stage& stage, const OrbitCamera& camera, const QSize& size,
                             const QFontMetricsF& metrics);

}  // namespace elsie::desktop

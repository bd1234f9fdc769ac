// Names of robots and goals over the view.
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

/// A box with the text, whose lower left corner is `at`.
QRectF label_box(const QFontMetricsF& metrics, const QPointF& at, const QString& text);

/// The names of the robots in a view of that size, then those of goals, without overlaps: each is
/// above its robot or goal, or a line higher or lower where another name is in the way. Names
/// without room are left out, those of goals and of robots far from the camera first; all together
/// cover a small part of the view.
std::vector<Label> labels_of(const Stage& stage, const OrbitCamera& camera, const QSize& size,
                             const QFontMetricsF& metrics);

}  // namespace elsie::desktop

// The lines behind the robots.
#pragma once

#include <QColor>
#include <QHash>
#include <QImage>
#include <QPainter>
#include <deque>

#include "scene/camera.h"
#include "scene/stage.h"

namespace elsie::desktop {

/// The path of each robot, at most the last 200 m. What was painted is kept while the camera stands
/// still, so that a picture costs only what was added since the last one.
class Trails {
 public:
  /// Adds the present places. A time before the last one changes nothing, because the past is
  /// shown; 0 s clears the trails.
  void note(const Stage& stage);
  void clear();
  /// Call it when the camera or the size changes.
  void paint_anew() { layer_ = QImage(); }
  /// Paints the trails at this size in px, into a picture with `ratio` device pixels for each.
  void paint(QPainter& painter, const OrbitCamera& camera, const QSize& size, double ratio);

 private:
  struct Trail {
    std::deque<Vector3> points;
    std::size_t painted = 0;  // how many of them are painted
    QColor colour;
  };
  static void paint_rest(QPainter& painter, Trail& trail, const OrbitCamera& camera,
                         const QSize& size);

  QHash<QString, Trail> trails_;  // by path
  double until_s_ = 0.0;
  QImage layer_;  // null: everything must be painted
};

}  // namespace elsie::desktop

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

/// Where each robot was, at most 200 m back. What was painted is kept for as long as the camera
/// stands still, so that a picture costs what has been added since the last.
class Trails {
 public:
  /// A time before the last one leaves them as they are, for the past is shown; 0 s forgets them.
  void note(const Stage& stage);
  void clear();
  /// To be called when the camera or the size changes.
  void paint_anew() { layer_ = QImage(); }
  /// Of this size in px, in a picture that has `ratio` px of the device for each.
  void paint(QPainter& painter, const OrbitCamera& camera, const QSize& size, double ratio);

 private:
  struct Trail {
    std::deque<Vector3> points;
    std::size_t painted = 0;  // points of them
    QColor colour;
  };
  static void paint_rest(QPainter& painter, Trail& trail, const OrbitCamera& camera,
                         const QSize& size);

  QHash<QString, Trail> trails_;  // by path
  double until_s_ = 0.0;
  QImage layer_;  // null: all is to be painted
};

}  // namespace elsie::desktop

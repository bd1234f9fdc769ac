// The lines behind the robots.
#pragma once

#include <QColor>
#include <QHash>
#include <QImage>
#include <QPainter>
#include <QPointF>
#include <vector>

#include "engine/past.h"
#include "scene/camera.h"
#include "scene/stage.h"

namespace elsie::desktop {

/// The path of each robot from the beginning of the run to the shown time, through the samples that
/// the engine stored. What was painted is kept while the camera stands still, so that a picture
/// costs only what was added since the last one.
class Trails {
 public:
  /// The past must outlive the trails.
  void show(const Past& past) { past_ = &past; }
  /// Leaves out what was before this time, s.
  void begin_at(double time_s);
  /// Call it when the camera, the size or the colours change.
  void paint_anew() { layer_ = QImage(); }
  /// Paints the trails at this size in px, into a picture with `ratio` device pixels for each.
  void paint(QPainter& painter, const Stage& stage, const OrbitCamera& camera, const QSize& size,
             double ratio);
  /// The path of a robot until a time, in pieces: where the robot was absent, or was put somewhere
  /// else by hand, another piece begins.
  std::vector<std::vector<QPointF>> pieces(const QString& robot, double until_s) const;

 private:
  /// Calls `see` for the points of the samples from the one with this index, and whether each is
  /// connected with the one before.
  template <class See>
  void visit(const QString& robot, std::size_t from, std::size_t end, const See& see) const;

  const Past* past_ = nullptr;
  double begins_at_s_ = 0.0;
  std::size_t painted_ = 0;  // samples
  int revision_ = 0;         // of the painted samples
  QImage layer_;             // null: everything must be painted
};

}  // namespace elsie::desktop

// The lines behind the robots.
#pragma once

#include <QColor>
#include <QHash>
#include <QImage>
#include <QLineF>
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
  /// The trails alone, at this size in px, with `ratio` device pixels for each. Null without a
  /// past.
  const QImage& paint(const Stage& stage, const OrbitCamera& camera, const QSize& size,
                      double ratio);
  /// The path of a robot until a time, in pieces: where the robot was absent, or was put somewhere
  /// else by hand, another piece begins.
  std::vector<std::vector<QPointF>> pieces(const QString& robot, double until_s) const;

  /// The place of a robot in a sample, and whether a line leads there from the one before.
  struct Point {
    std::size_t sample = 0;
    QPointF at;
    bool is_connected = false;
  };
  /// The points that are painted: those of the whole past without the ones nearer than 1 cm to the
  /// one before, so that a robot that stands adds none.
  const std::vector<Point>& points(const QString& robot) const;

 private:
  struct Painted {
    std::size_t samples = 0;  // that have been seen
    std::vector<Point> points;
  };

  /// Calls `see` for the points of the samples from the one with this index.
  template <class See>
  void visit(const QString& robot, std::size_t from, std::size_t end, const See& see) const;

  const Past* past_ = nullptr;
  double begins_at_s_ = 0.0;
  std::size_t painted_ = 0;  // samples
  int revision_ = 0;         // of the painted samples
  mutable QHash<QString, Painted> painted_points_;
  mutable int points_revision_ = 0;
  QImage layer_;  // null: everything must be painted
};

}  // namespace elsie::desktop

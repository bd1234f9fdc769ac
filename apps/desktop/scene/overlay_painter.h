// What is drawn over the solids: numbers of the grid, marks of plugins, names.
#pragma once

#include <QPainter>
#include <QSize>

#include "scene/camera.h"
#include "scene/labels.h"
#include "scene/stage.h"

namespace elsie::desktop {

/// Draws points of the world as a camera sees them.
class OverlayPainter {
 public:
  OverlayPainter(QPainter& painter, const Stage& stage, const OrbitCamera& camera,
                 const QSize& size, const QColor& scale_ink)
      : painter_(painter), stage_(stage), camera_(camera), size_(size), scale_ink_(scale_ink) {}

  /// Draws a line. A line that ends behind the camera is cut at the camera's plane.
  void line(const Vector3& from, const Vector3& to) const;
  /// Draws outlines in place of solids, without OpenGL.
  void outlines() const;
  /// Draws lines in place of a renderer.
  void strokes(const std::vector<render::Stroke>& strokes) const;
  /// Draws the numbers of the grid along two edges of the arena, and the letters of its axes.
  /// None of them lies in `taken`.
  void scale(const QRectF& taken) const;
  /// Draws what plugins draw, in a style for each role, but for lines.
  void sketches() const;
  /// Draws a ring around each robot that is too small to be seen.
  void rings() const;
  /// Draws the names of robots.
  void names() const;
  /// Draws a box with a text; its lower left corner is `at`.
  void note(const QPointF& at, const QString& text) const;

 private:
  void note(const Label& label) const;
  void arrow_head(const Vector3& from, const Vector3& to) const;
  void point(const Vector3& at, SketchRole role) const;
  /// Where the number is, beyond that edge of the arena; empty if it is not in the picture.
  QRectF box_of_number(const Vector3& at, const Vector3& away, const QString& text) const;

  QPainter& painter_;
  const Stage& stage_;
  const OrbitCamera& camera_;
  QSize size_;
  QColor scale_ink_;
};

}  // namespace elsie::desktop

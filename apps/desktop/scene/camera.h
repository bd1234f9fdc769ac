// From where the window looks, and where points of the world are in it.
#pragma once

#include <QPointF>
#include <QSizeF>
#include <optional>

#include "elsie/api/geometry.h"
#include "elsie/api/image.h"

namespace elsie::desktop {

/// A camera that turns round a point, looks at it, and moves with it. Angles are in rad.
class OrbitCamera {
 public:
  static constexpr double kFov = 0.9;  // horizontal

  Vector3 target;
  double distance = 10.0;  // m
  double yaw = 1.45;       // of its line of sight, from +x
  double pitch = -0.95;    // negative looks down

  /// Shows an area around the origin whole, obliquely from the south or from above.
  void show(double length, double width, const QSizeF& size);
  void look_from_top();
  void look_from_front();
  void look_from_side();

  /// By movements of the mouse, px.
  void orbit(const QPointF& by);
  void pan(const QPointF& by, const QSizeF& size);
  /// Nearer to what is under the pointer if `factor` is below 1.
  void zoom(double factor, const QPointF& pointer, const QSizeF& size);

  friend bool operator==(const OrbitCamera&, const OrbitCamera&) = default;

  Frame frame() const;
  /// None: behind the camera.
  std::optional<QPointF> project(const Vector3& point, const QSizeF& size) const;
  /// The direction in which a pixel looks.
  Vector3 ray(const QPointF& pixel, const QSizeF& size) const;
  /// Where that ray meets the plane at this height; none if it does not.
  std::optional<Vector3> on_plane(const QPointF& pixel, const QSizeF& size,
                                  double height = 0.0) const;
};

}  // namespace elsie::desktop

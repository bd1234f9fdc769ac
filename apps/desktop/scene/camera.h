// The camera of the view: where it is, and where points of the world are in its picture.
#pragma once

#include <QPointF>
#include <QSizeF>
#include <numbers>
#include <optional>

#include "elsie/api/geometry.h"
#include "elsie/api/image.h"

namespace elsie::desktop {

/// A camera that orbits a point, looks at it, and moves with it. Angles are in rad.
class OrbitCamera {
 public:
  static constexpr double kFov = 0.9;  // horizontal

  Vector3 target;
  double distance = 10.0;  // m
  double yaw = 1.45;       // direction of its line of sight, from +x
  double pitch = -0.95;    // negative looks down
  double raised = 0.0;     // how much steeper it looks down, so that nothing hides its target
  /// Where the camera is carried by a robot; none: it orbits.
  std::optional<Frame> seat{};

  /// Fills the picture with an area around the origin, `height` m high, seen from where it looks.
  void show(double length, double width, double height, const QSizeF& size);
  /// Where the camera looks from, whatever its target is.
  struct View {
    double yaw, pitch;
  };
  static constexpr View kFromTop{0.5 * std::numbers::pi, -0.5 * std::numbers::pi};
  static constexpr View kFromFront{0.5 * std::numbers::pi, -0.15};
  static constexpr View kFromSide{std::numbers::pi, -0.15};
  static constexpr View kIsometric{0.25 * std::numbers::pi, -0.6155};  // asin(tan 30 degrees)

  /// Whether raising it more would change anything.
  bool can_rise() const { return pitch - raised > kFromTop.pitch; }
  /// Stays where it was raised to.
  void stay_raised();

  /// Move the camera by a movement of the mouse, px.
  void orbit(const QPointF& by);
  void pan(const QPointF& by, const QSizeF& size);
  /// Zooms towards the point under the pointer if `factor` is below 1, otherwise away from it.
  void zoom(double factor, const QPointF& pointer, const QSizeF& size);

  /// Whether both orbit alike.
  friend bool operator==(const OrbitCamera& a, const OrbitCamera& b) {
    return a.target == b.target && a.distance == b.distance && a.yaw == b.yaw &&
           a.pitch == b.pitch && a.raised == b.raised && a.seat.has_value() == b.seat.has_value();
  }

  Frame frame() const;
  /// The horizontal field of view, rad: wider in a robot's place.
  double fov() const { return seat ? 1.25 : kFov; }
  /// The pixel of a point; none if the point is behind the camera.
  std::optional<QPointF> project(const Vector3& point, const QSizeF& size) const;
  /// The direction in which a pixel looks.
  Vector3 ray(const QPointF& pixel, const QSizeF& size) const;
  /// The point where that ray meets the plane at this height; none if it does not.
  std::optional<Vector3> on_plane(const QPointF& pixel, const QSizeF& size,
                                  double height = 0.0) const;

 private:
  double scale(const QSizeF& size) const;
  void stay_above_the_floor();
};

}  // namespace elsie::desktop

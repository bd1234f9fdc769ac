#include "scene/camera.h"

#include <QMarginsF>
#include <QRectF>
#include <algorithm>
#include <cmath>

namespace elsie::desktop {
namespace {

constexpr double kFlattest = 0.1;
constexpr double kNearest = 0.05;  // m
constexpr double kFarthest = 30'000.0;
constexpr double kPerPixel = 0.008;  // rad
constexpr double kInFront = 0.01;    // m; nearer points are not drawn

/// The distance in pixels from the middle of the picture to a point one unit ahead and one unit
/// aside.
double scale(const QSizeF& size) { return 0.5 * size.width() / std::tan(0.5 * OrbitCamera::kFov); }

}  // namespace

void OrbitCamera::show(double length, double width, const QSizeF& size) {
  target = {0.0, 0.0, 0.0};
  // Moves away until all corners are in the picture.
  const QSizeF picture(std::max(1.0, size.width()), std::max(1.0, size.height()));
  const QRectF frame = QRectF(QPointF(0.0, 0.0), picture).marginsRemoved({12.0, 24.0, 12.0, 12.0});
  for (distance = 0.3 * std::max(length, width); distance < kFarthest; distance *= 1.05) {
    bool is_whole = true;
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5}) {
        const auto at = project({x * 1.05 * length, y * 1.05 * width, 0.0}, picture);
        is_whole = is_whole && at && frame.contains(*at);
      }
    }
    if (is_whole || frame.isEmpty()) {
      break;
    }
  }
}

void OrbitCamera::orbit(const QPointF& by) {
  yaw = wrap_angle(yaw - kPerPixel * by.x());
  pitch = std::clamp(pitch - kPerPixel * by.y(), kFromTop.pitch, kFlattest);
}

void OrbitCamera::pan(const QPointF& by, const QSizeF& size) {
  const Frame now = frame();
  const double meters = distance / scale(size);
  // Moves along the floor: "ahead" is where `up` points if seen from above, otherwise where
  // `forward` points.
  Vector3 ahead{now.forward.x + now.up.x, now.forward.y + now.up.y, 0.0};
  ahead = (1.0 / std::max(1e-9, std::hypot(ahead.x, ahead.y))) * ahead;
  target = target + meters * by.x() * now.left + meters * by.y() * ahead;
}

void OrbitCamera::zoom(double factor, const QPointF& pointer, const QSizeF& size) {
  const auto under = on_plane(pointer, size);
  const double before = distance;
  distance = std::clamp(distance * factor, kNearest, kFarthest);
  if (under) {
    const double moved = 1.0 - distance / before;
    const Vector3 aside = *under - target;
    if (std::hypot(aside.x, aside.y) < 5.0 * before) {
      target = target + moved * Vector3{aside.x, aside.y, 0.0};
    }
  }
}

Frame OrbitCamera::frame() const {
  Frame frame = Frame::turned({}, yaw, pitch);
  frame.origin = target - distance * frame.forward;
  return frame;
}

std::optional<QPointF> OrbitCamera::project(const Vector3& point, const QSizeF& size) const {
  const Frame eye = frame();
  const Vector3 seen = point - eye.origin;
  const double ahead = dot(seen, eye.forward);
  if (ahead < kInFront) {
    return std::nullopt;
  }
  const double pixels = scale(size) / ahead;
  return QPointF(0.5 * size.width() - pixels * dot(seen, eye.left),
                 0.5 * size.height() - pixels * dot(seen, eye.up));
}

Vector3 OrbitCamera::ray(const QPointF& pixel, const QSizeF& size) const {
  const Frame eye = frame();
  const double pixels = scale(size);
  return eye.direction(
      {1.0, (0.5 * size.width() - pixel.x()) / pixels, (0.5 * size.height() - pixel.y()) / pixels});
}

std::optional<Vector3> OrbitCamera::on_plane(const QPointF& pixel, const QSizeF& size,
                                             double height) const {
  const Vector3 direction = ray(pixel, size);
  const Vector3 from = frame().origin;
  const double way = (height - from.z) / direction.z;
  if (!std::isfinite(way) || way <= 0.0) {
    return std::nullopt;
  }
  return from + way * direction;
}

}  // namespace elsie::desktop

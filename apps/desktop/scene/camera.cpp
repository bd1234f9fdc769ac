#include "scene/camera.h"

#include <QMarginsF>
#include <QRectF>
#include <algorithm>
#include <cmath>

namespace elsie::desktop {
namespace {

constexpr double kLowest = 0.03;   // m, above the floor
constexpr double kNearest = 0.05;  // m
constexpr double kFarthest = 30'000.0;
constexpr double kPerPixel = 0.008;  // rad
constexpr double kInFront = 0.01;    // m; nearer points are not drawn

}  // namespace

/// The distance in pixels from the middle of the picture to a point one unit ahead and one unit
/// aside.
double OrbitCamera::scale(const QSizeF& size) const {
  return 0.5 * size.width() / std::tan(0.5 * fov());
}

void OrbitCamera::show(double length, double width, double height, const QSizeF& size) {
  seat.reset();
  raised = 0.0;
  target = {0.0, 0.0, 0.0};
  const QSizeF picture(std::max(1.0, size.width()), std::max(1.0, size.height()));
  const QRectF frame = QRectF(QPointF(0.0, 0.0), picture).marginsRemoved({16.0, 28.0, 16.0, 28.0});
  // What of the picture the corners of the area fill; none if one is behind the camera.
  const auto filled = [&]() -> std::optional<QRectF> {
    QRectF all;
    for (int corner = 0; corner < 8; ++corner) {
      const auto at = project({(corner & 1 ? 0.5 : -0.5) * length,
                               (corner & 2 ? 0.5 : -0.5) * width, corner & 4 ? height : 0.0},
                              picture);
      if (!at) return std::nullopt;
      all = corner == 0
                ? QRectF(*at, QSizeF(0.0, 0.0))
                : QRectF(QPointF(std::min(all.left(), at->x()), std::min(all.top(), at->y())),
                         QPointF(std::max(all.right(), at->x()), std::max(all.bottom(), at->y())));
    }
    return all;
  };
  // Moves away until all corners are in the picture, with the area in its middle.
  for (distance = 0.2 * std::max(length, width); distance < kFarthest; distance *= 1.02) {
    target = {0.0, 0.0, 0.0};
    for (int i = 0; i < 3; ++i) {
      if (const auto area = filled()) pan(frame.center() - area->center(), picture);
    }
    const auto area = filled();
    if (frame.isEmpty() || (area && frame.contains(*area))) break;
  }
}

void OrbitCamera::stay_raised() {
  pitch = std::max(pitch - raised, kFromTop.pitch);
  raised = 0.0;
}

void OrbitCamera::orbit(const QPointF& by) {
  stay_raised();
  yaw = wrap_angle(yaw - kPerPixel * by.x());
  pitch = std::max(pitch - kPerPixel * by.y(), kFromTop.pitch);
  stay_above_the_floor();
}

void OrbitCamera::stay_above_the_floor() {
  pitch = std::min(pitch, -std::asin(std::min(1.0, kLowest / distance)));
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
  stay_above_the_floor();
}

Frame OrbitCamera::frame() const {
  if (seat) return *seat;
  Frame frame = Frame::turned({}, yaw, std::max(pitch - raised, kFromTop.pitch));
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

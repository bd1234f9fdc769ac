#include "scene/labels.h"

#include <algorithm>
#include <utility>

#include "engine/elements.h"

namespace elsie::desktop {
namespace {

constexpr double kHigh = 0.15;  // m, above the foot of a robot
constexpr double kAside = 3.0;  // space at the sides of the text in its box
constexpr double kAbove = 6.0;  // px

}  // namespace

QRectF label_box(const QFontMetricsF& metrics, const QPointF& at, const QString& text) {
  return {at.x(), at.y() - metrics.height(), metrics.horizontalAdvance(text) + 2.0 * kAside,
          metrics.height()};
}

std::vector<Label> labels_of(const Stage& stage, const OrbitCamera& camera, const QSize& size,
                             const QFontMetricsF& metrics) {
  const Frame eye = camera.frame();
  std::vector<std::pair<double, const Stage::Body*>> robots;
  for (const Stage::Body& body : stage.bodies()) {
    if (body.is_present && body.is_robot()) {
      robots.emplace_back(dot(body.frame.origin - eye.origin, eye.forward), &body);
    }
  }
  std::stable_sort(robots.begin(), robots.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  const QRectF view(QPointF(0.0, 0.0), QSizeF(size));
  std::vector<Label> labels;
  for (const auto& [ahead, robot] : robots) {
    const auto at = camera.project(robot->frame.point({0.0, 0.0, kHigh}), size);
    const QString name = robot_id(robot->path);
    if (!at) {
      continue;
    }
    const QPointF corner(at->x() - 0.5 * metrics.horizontalAdvance(name) - kAside,
                         at->y() - kAbove);
    for (const double lines : {0.0, -1.0, 1.0}) {
      const QRectF box = label_box(metrics, corner + QPointF(0.0, lines * metrics.height()), name);
      if (box.intersects(view) &&
          std::none_of(labels.begin(), labels.end(),
                       [&box](const Label& other) { return other.box.intersects(box); })) {
        labels.push_back({name, box});
        break;
      }
    }
  }
  return labels;
}

}  // namespace elsie::desktop

#include "scene/labels.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/elements.h"

namespace elsie::desktop {
namespace {

constexpr double kHigh = 0.15;         // m, above the foot of a robot
constexpr double kAside = 3.0;         // space at the sides of the text in its box
constexpr double kAbove = 6.0;         // px
constexpr double kMostCovered = 0.15;  // of the view, by all of them

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
  double room = kMostCovered * view.width() * view.height();
  const auto add = [&](const Vector3& place, const QString& name) {
    if (room < 0.0) return;
    const auto at = camera.project(place, size);
    if (!at) return;
    const QPointF corner(at->x() - 0.5 * metrics.horizontalAdvance(name) - kAside,
                         at->y() - kAbove);
    for (const double lines : {0.0, -1.0, 1.0}) {
      const QRectF box = label_box(metrics, corner + QPointF(0.0, lines * metrics.height()), name);
      if (box.intersects(view) &&
          std::none_of(labels.begin(), labels.end(),
                       [&box](const Label& other) { return other.box.intersects(box); })) {
        labels.push_back({name, box});
        room -= box.width() * box.height();
        return;
      }
    }
  };
  for (const auto& [ahead, robot] : robots) {
    add(robot->frame.point({0.0, 0.0, kHigh}), robot_id(robot->path));
  }
  for (const Stage::Goal& goal : stage.goals()) {
    // At the edge of the place that is highest in the picture.
    const Vector3 away = eye.forward + eye.up;
    const double part = goal.radius / std::max(1e-9, std::hypot(away.x, away.y));
    add({goal.at.x + part * away.x, goal.at.y + part * away.y, 0.0},
        goal.whose.isEmpty() ? QCoreApplication::translate("Labels", "goal")
                             : QCoreApplication::translate("Labels", "goal of %1").arg(goal.whose));
  }
  return labels;
}

}  // namespace elsie::desktop

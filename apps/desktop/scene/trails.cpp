#include "scene/trails.h"

#include <algorithm>
#include <cmath>

namespace elsie::desktop {
namespace {

constexpr double kStep = 0.01;  // m
constexpr std::size_t kLongest = 20'000;
constexpr double kHeight = 0.005;  // m; above the marks on the floor
constexpr double kWidth = 1.6;     // px

}  // namespace

void Trails::clear() {
  trails_.clear();
  until_s_ = 0.0;
  paint_anew();
}

void Trails::note(const Stage& stage) {
  if (stage.time_s() < until_s_) {
    if (stage.time_s() == 0.0) {
      clear();
    }
    return;
  }
  until_s_ = stage.time_s();
  for (const Stage::Body& body : stage.bodies()) {
    if (!body.is_robot()) {
      continue;
    }
    Trail& trail = trails_[body.path];
    trail.colour = QColor(body.colour.red, body.colour.green, body.colour.blue);
    const Vector3 at{body.frame.origin.x, body.frame.origin.y, kHeight};
    if (!trail.points.empty() &&
        std::hypot(at.x - trail.points.back().x, at.y - trail.points.back().y) < kStep) {
      continue;
    }
    trail.points.push_back(at);
    if (trail.points.size() > kLongest) {
      trail.points.pop_front();
      trail.painted -= std::min<std::size_t>(1, trail.painted);
    }
  }
}

void Trails::paint(QPainter& painter, const OrbitCamera& camera, const QSize& size, double ratio) {
  if (layer_.size() != size * ratio) {
    layer_ = QImage(size * ratio, QImage::Format_ARGB32_Premultiplied);
    layer_.setDevicePixelRatio(ratio);
    layer_.fill(Qt::transparent);
    for (Trail& trail : trails_) {
      trail.painted = 0;
    }
  }
  QPainter lines(&layer_);
  lines.setRenderHint(QPainter::Antialiasing);
  for (Trail& trail : trails_) {
    paint_rest(lines, trail, camera, size);
  }
  lines.end();
  painter.drawImage(QPoint(0, 0), layer_);
}

void Trails::paint_rest(QPainter& painter, Trail& trail, const OrbitCamera& camera,
                        const QSize& size) {
  if (trail.painted == trail.points.size()) {
    return;
  }
  painter.setPen(QPen(trail.colour, kWidth));
  QPolygonF run;
  for (std::size_t i = trail.painted - std::min<std::size_t>(1, trail.painted);
       i < trail.points.size(); ++i) {
    if (const auto at = camera.project(trail.points[i], size)) {
      run << *at;
    } else if (!run.isEmpty()) {
      painter.drawPolyline(run);
      run.clear();
    }
  }
  painter.drawPolyline(run);
  trail.painted = trail.points.size();
}

}  // namespace elsie::desktop

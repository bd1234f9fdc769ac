#include "scene/trails.h"

#include <algorithm>
#include <cmath>

#include "engine/elements.h"

namespace elsie::desktop {
namespace {

constexpr double kHeight = 0.005;    // m; above the marks on the floor
constexpr double kWidth = 1.6;       // px
constexpr double kIndistinct = 0.5;  // px; nearer points look like one
constexpr double kApart = 0.01;      // m; nearer points are not painted

}  // namespace

void Trails::begin_at(double time_s) {
  begins_at_s_ = time_s;
  painted_points_.clear();
  paint_anew();
}

template <class See>
void Trails::visit(const QString& robot, std::size_t from, std::size_t end, const See& see) const {
  const Samples& paths = past_->paths();
  const std::vector<float>* const x = paths.curve(robot + "/x");
  const std::vector<float>* const y = paths.curve(robot + "/y");
  if (!x || !y) {
    return;
  }
  const std::vector<double>& times = paths.times();
  const std::vector<Placed>& all = past_->placed();
  auto placed = all.begin();
  if (from > 0) {
    placed =
        std::lower_bound(all.begin(), all.end(), times[from - 1],
                         [](const Placed& each, double time_s) { return each.time_s < time_s; });
  }
  for (std::size_t i = from; i < end; ++i) {
    bool was_placed = false;  // since the sample before
    for (; placed != all.end() && placed->time_s < times[i]; ++placed) {
      was_placed = was_placed || placed->robot == robot;
    }
    if (times[i] < begins_at_s_ || !std::isfinite((*x)[i]) || !std::isfinite((*y)[i])) {
      continue;
    }
    const bool is_connected =
        i > 0 && times[i - 1] >= begins_at_s_ && std::isfinite((*x)[i - 1]) && !was_placed;
    see(Point{i, {(*x)[i], (*y)[i]}, is_connected});
  }
}

const std::vector<Trails::Point>& Trails::points(const QString& robot) const {
  if (points_revision_ != past_->paths().revision()) {
    painted_points_.clear();
    points_revision_ = past_->paths().revision();
  }
  Painted& painted = painted_points_[robot];
  const std::size_t end = past_->paths().times().size();
  visit(robot, painted.samples, end, [&](const Point& point) {
    std::vector<Point>& points = painted.points;
    if (!point.is_connected || points.empty() ||
        QLineF(points.back().at, point.at).length() >= kApart) {
      points.push_back(point);
    }
  });
  painted.samples = end;
  return painted.points;
}

std::vector<std::vector<QPointF>> Trails::pieces(const QString& robot, double until_s) const {
  std::vector<std::vector<QPointF>> pieces;
  if (past_) {
    visit(robot, 0, past_->paths().count_until(until_s), [&](const Point& point) {
      (point.is_connected ? pieces.back() : pieces.emplace_back()).push_back(point.at);
    });
  }
  return pieces;
}

const QImage& Trails::paint(const Stage& stage, const OrbitCamera& camera, const QSize& size,
                            double ratio) {
  if (!past_) {
    return layer_;
  }
  const Samples& paths = past_->paths();
  const std::size_t end = paths.count_until(stage.time_s());
  if (layer_.size() != size * ratio || revision_ != paths.revision() || end < painted_) {
    layer_ = QImage(size * ratio, QImage::Format_ARGB32_Premultiplied);
    layer_.setDevicePixelRatio(ratio);
    layer_.fill(Qt::transparent);
    painted_ = 0;
    revision_ = paths.revision();
  }
  if (painted_ < end) {
    QPainter lines(&layer_);
    lines.setRenderHint(QPainter::Antialiasing);
    for (const Stage::Body& body : stage.bodies()) {
      if (!body.is_robot()) {
        continue;
      }
      lines.setPen(QPen(QColor(body.colour.red, body.colour.green, body.colour.blue), kWidth));
      QPolygonF run;
      QPointF last;  // perhaps too near to be in it
      const auto draw = [&] {
        if (!run.isEmpty() && run.back() != last) run << last;
        if (run.size() > 1) lines.drawPolyline(run);
        run.clear();
      };
      const std::vector<Point>& points = this->points(robot_id(body.path));
      const auto is_before = [](const Point& point, std::size_t sample) {
        return point.sample < sample;
      };
      auto point = std::lower_bound(points.begin(), points.end(), painted_, is_before);
      if (point != points.begin()) {
        --point;  // where the next line begins
      }
      for (; point != points.end() && point->sample < end; ++point) {
        const auto at = camera.project({point->at.x(), point->at.y(), kHeight}, size);
        if (!point->is_connected || !at) {
          draw();
        }
        if (!at) {
          continue;
        }
        if (run.isEmpty() || QLineF(run.back(), *at).length() >= kIndistinct) {
          run << *at;
        }
        last = *at;
      }
      draw();
    }
    painted_ = end;
  }
  return layer_;
}

}  // namespace elsie::desktop

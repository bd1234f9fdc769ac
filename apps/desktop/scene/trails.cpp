#include "scene/trails.h"

#include <algorithm>
#include <cmath>

namespace elsie::desktop {
namespace {

constexpr double kHeight = 0.005;    // m; above the marks on the floor
constexpr double kWidth = 1.6;       // px
constexpr double kIndistinct = 0.5;  // px; nearer points look like one

}  // namespace

void Trails::begin_at(double time_s) {
  begins_at_s_ = time_s;
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
  std::vector<double> placed;
  for (const Placed& each : past_->placed()) {
    if (each.robot == robot) placed.push_back(each.time_s);
  }
  const std::vector<double>& times = paths.times();
  const auto was_placed = [&](std::size_t before) {
    return std::any_of(placed.begin(), placed.end(), [&](double time_s) {
      return times[before] <= time_s && time_s < times[before + 1];
    });
  };
  for (std::size_t i = from; i < end; ++i) {
    if (times[i] < begins_at_s_ || !std::isfinite((*x)[i]) || !std::isfinite((*y)[i])) {
      continue;
    }
    const bool is_connected = i > from && times[i - 1] >= begins_at_s_ &&
                              std::isfinite((*x)[i - 1]) && !was_placed(i - 1);
    see(QPointF((*x)[i], (*y)[i]), is_connected);
  }
}

std::vector<std::vector<QPointF>> Trails::pieces(const QString& robot, double until_s) const {
  std::vector<std::vector<QPointF>> pieces;
  if (past_) {
    visit(robot, 0, past_->paths().count_until(until_s), [&](const QPointF& at, bool is_connected) {
      (is_connected ? pieces.back() : pieces.emplace_back()).push_back(at);
    });
  }
  return pieces;
}

void Trails::paint(QPainter& painter, const Stage& stage, const OrbitCamera& camera,
                   const QSize& size, double ratio) {
  if (!past_) {
    return;
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
    const std::size_t from = painted_ - std::min<std::size_t>(1, painted_);
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
      visit(body.robot(), from, end, [&](const QPointF& point, bool is_connected) {
        const auto at = camera.project({point.x(), point.y(), kHeight}, size);
        if (!is_connected || !at) {
          draw();
        }
        if (!at) {
          return;
        }
        if (run.isEmpty() || QLineF(run.back(), *at).length() >= kIndistinct) {
          run << *at;
        }
        last = *at;
      });
      draw();
    }
    painted_ = end;
  }
  painter.drawImage(QPoint(0, 0), layer_);
}

}  // namespace elsie::desktop

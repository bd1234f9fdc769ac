#include "scene/overlay_painter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "elsie/picture/axis.h"

namespace elsie::desktop {
namespace {

constexpr double kViewRange = 0.5;  // m: how far a field of view is drawn
constexpr double kNear = 0.02;      // m, from the camera

const QColor kBeam(0x2a, 0x7a, 0xb8, 110);
const QColor kHit(0xc0, 0x30, 0x30, 210);
const QColor kGrid(0, 0, 0, 28);
const QColor kView(0x80, 0x60, 0xb0, 110);
const QColor kPaper(255, 255, 255, 215);
const QColor kInk(25, 25, 25);

}  // namespace

void OverlayPainter::line(const Vector3& from, const Vector3& to) const {
  const Frame eye = camera_.frame();
  Vector3 a = from, b = to;
  const double ahead_a = dot(a - eye.origin, eye.forward),
               ahead_b = dot(b - eye.origin, eye.forward);
  if (ahead_a < kNear && ahead_b < kNear) {
    return;
  }
  if (ahead_a < kNear) a = a + ((kNear - ahead_a) / (ahead_b - ahead_a)) * (b - a);
  if (ahead_b < kNear) b = b + ((kNear - ahead_b) / (ahead_a - ahead_b)) * (a - b);
  const auto begin = camera_.project(a, size_), end = camera_.project(b, size_);
  if (begin && end) {
    painter_.drawLine(*begin, *end);
  }
}

void OverlayPainter::outlines() const {
  for (const Stage::Solid& solid : stage_.solids()) {
    if (stage_.is_present(solid)) {
      const QColor colour(solid.colour.red, solid.colour.green, solid.colour.blue);
      painter_.setPen(QPen(colour.darker(120), 1.5));
      for (const auto& [from, to] : edges_of(solid, stage_.frame_of(solid))) {
        line(from, to);
      }
    }
  }
}

void OverlayPainter::grid() const {
  painter_.setPen(QPen(kGrid, 1.0));
  const double x = 0.5 * stage_.length(), y = 0.5 * stage_.width();
  const double step = picture::nice_step(std::max(stage_.length(), stage_.width()), 10);
  for (const double at : picture::multiples(-x, x, step).at) {
    line({at, -y, 0.0}, {at, y, 0.0});
  }
  for (const double at : picture::multiples(-y, y, step).at) {
    line({-x, at, 0.0}, {x, at, 0.0});
  }
}

void OverlayPainter::beams() const {
  const QPen free(kBeam, 1.0), hit(kHit, 1.2, Qt::DashLine);
  for (const snapshots::BeamState& beam : stage_.beams()) {
    painter_.setPen(beam.hit ? hit : free);
    line({beam.from[0], beam.from[1], beam.from[2]}, {beam.to[0], beam.to[1], beam.to[2]});
  }
}

void OverlayPainter::views() const {
  painter_.setPen(QPen(kView, 1.0));
  for (const Stage::View& view : stage_.views()) {
    const Stage::Body& body = stage_.bodies()[view.body];
    if (!body.is_present) {
      continue;
    }
    const Frame frame = body.frame.frame(view.frame);
    const double aside = kViewRange * std::tan(0.5 * view.fov_rad);
    const double above = aside * view.aspect;
    const std::array<Vector3, 4> corners{
        frame.point({kViewRange, aside, above}), frame.point({kViewRange, -aside, above}),
        frame.point({kViewRange, -aside, -above}), frame.point({kViewRange, aside, -above})};
    for (std::size_t i = 0; i < 4; ++i) {
      line(frame.origin, corners[i]);
      line(corners[i], corners[(i + 1) % 4]);
    }
  }
}

void OverlayPainter::names() const {
  for (const Label& each : labels_of(stage_, camera_, size_, QFontMetricsF(painter_.font()))) {
    note(each);
  }
}

void OverlayPainter::note(const QPointF& at, const QString& text) const {
  note({text, label_box(QFontMetricsF(painter_.font()), at, text)});
}

void OverlayPainter::note(const Label& label) const {
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(kPaper);
  painter_.drawRoundedRect(label.box, 3.0, 3.0);
  painter_.setPen(kInk);
  painter_.setBrush(Qt::NoBrush);
  painter_.drawText(label.box, Qt::AlignCenter, label.text);
}

}  // namespace elsie::desktop

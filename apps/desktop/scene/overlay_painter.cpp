#include "scene/overlay_painter.h"

#include <QLineF>
#include <algorithm>
#include <array>
#include <cmath>

#include "elsie/picture/axis.h"

namespace elsie::desktop {
namespace {

constexpr double kNear = 0.02;  // m, from the camera

const QColor kGrid(0, 0, 0, 28);
const QColor kPaper(255, 255, 255, 215);
const QColor kInk(25, 25, 25);

struct RoleStyle {
  QColor colour;
  double width;
  Qt::PenStyle line = Qt::SolidLine;
};

const RoleStyle& style_of(SketchRole role) {
  static const std::array<RoleStyle, 7> styles{
      {{QColor(0x2a, 0x7a, 0xb8, 110), 1.0},                // range
       {QColor(0xc0, 0x30, 0x30, 210), 1.2, Qt::DashLine},  // hit
       {QColor(0x2f, 0x6f, 0x9f, 80), 1.0},                 // field
       {QColor(0x1b, 0x5f, 0xb0, 230), 1.4},                // target
       {QColor(0x9c, 0x2f, 0x8a, 230), 1.8},                // wish
       {QColor(0x5a, 0x5f, 0x6b, 220), 1.4, Qt::DotLine},   // belief
       {QColor(0x00, 0x83, 0x8f, 220), 1.6}}};              // message
  // The memory is shared with a process that runs plugins.
  return styles[std::min(static_cast<std::size_t>(role), styles.size() - 1)];
}

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

void OverlayPainter::sketches() const {
  for (const snapshots::MarkState& mark : stage_.marks()) {
    const RoleStyle& style = style_of(mark.role);
    painter_.setPen(QPen(style.colour, style.width, style.line));
    switch (mark.kind) {
      case Sketch::Kind::points:
        point(mark.begin(), mark.role);
        break;
      case Sketch::Kind::line:
        line(mark.begin(), mark.end());
        break;
      case Sketch::Kind::arrow:
        line(mark.begin(), mark.end());
        arrow_head(mark.begin(), mark.end());
        break;
      case Sketch::Kind::text:
        if (const auto at = camera_.project(mark.begin(), size_)) {
          painter_.drawText(*at, QString::fromUtf8(mark.text));
        }
        break;
    }
  }
}

void OverlayPainter::arrow_head(const Vector3& from, const Vector3& to) const {
  const auto begin = camera_.project(from, size_), end = camera_.project(to, size_);
  if (!begin || !end) {
    return;
  }
  const QLineF shaft(*end, *begin);
  constexpr double kLength = 8.0, kAngle = 25.0;  // pixels, degrees
  for (const double angle : {-kAngle, kAngle}) {
    QLineF side = shaft;
    side.setLength(std::min(kLength, shaft.length()));
    side.setAngle(shaft.angle() + angle);
    painter_.drawLine(side);
  }
}

void OverlayPainter::point(const Vector3& place, SketchRole role) const {
  const auto at = camera_.project(place, size_);
  if (!at) {
    return;
  }
  constexpr double kDot = 2.5, kRing = 5.0, kArm = 8.0;  // pixels
  if (role == SketchRole::target) {
    painter_.drawEllipse(*at, kRing, kRing);
    painter_.drawLine(*at - QPointF(kArm, 0.0), *at + QPointF(kArm, 0.0));
    painter_.drawLine(*at - QPointF(0.0, kArm), *at + QPointF(0.0, kArm));
  } else if (role == SketchRole::belief) {
    painter_.drawEllipse(*at, kDot, kDot);
  } else {
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(style_of(role).colour);
    painter_.drawEllipse(*at, kDot, kDot);
    painter_.setBrush(Qt::NoBrush);
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

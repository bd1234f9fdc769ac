#include "scene/overlay_painter.h"

#include <QLineF>
#include <algorithm>
#include <cmath>

#include "elsie/picture/axis.h"
#include "elsie/render/sketch_style.h"

#include "scene/drawing.h"

namespace elsie::desktop {
namespace {

constexpr double kNear = 0.02;  // m, from the camera

const QColor kPaper(255, 255, 255, 215);
const QColor kInk(25, 25, 25);

QColor colour_of(const Colour& colour, double opacity = 1.0) {
  QColor made(colour.red, colour.green, colour.blue);
  made.setAlphaF(static_cast<float>(opacity));
  return made;
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

void OverlayPainter::strokes(const std::vector<render::Stroke>& strokes) const {
  for (const render::Stroke& stroke : strokes) {
    painter_.setPen(QPen(colour_of(stroke.colour, stroke.opacity), stroke.width,
                         stroke.dash > 0.0 ? Qt::DashLine : Qt::SolidLine));
    line(stroke.from, stroke.to);
  }
}

void OverlayPainter::scale(const QRectF& taken) const {
  const double x = 0.5 * stage_.length(), y = 0.5 * stage_.width();
  const double step = grid_step(stage_, camera_);
  const double aside = 0.1 + 0.02 * std::max(x, y);  // beyond a wall
  const Vector3 eye = camera_.frame().origin;
  // Along the edges nearest to the camera; seen from above, along the lower and the left one.
  const auto pixel = [&](double at_x, double at_y) {
    return camera_.project({at_x, at_y, 0.0}, size_).value_or(QPointF());
  };
  constexpr double kAbove = 0.1;  // of the arena: nearer to its middle the camera is above it
  const auto sign = [](bool is_low) { return is_low ? -1.0 : 1.0; };
  const double south =
      sign(std::abs(eye.y) > kAbove * y ? eye.y < 0.0 : pixel(0.0, -y).y() > pixel(0.0, y).y());
  const double west =
      sign(std::abs(eye.x) > kAbove * x ? eye.x < 0.0 : pixel(-x, 0.0).x() < pixel(x, 0.0).x());
  const QFont before = painter_.font();
  QFont small = before;
  small.setPointSizeF(0.85 * small.pointSizeF());
  painter_.setFont(small);
  painter_.setPen(scale_ink_);
  const auto along = [&](double reach, const auto& place, const Vector3& away, const char* axis) {
    const picture::Ticks ticks = picture::multiples(-reach, reach, step);
    if (ticks.at.empty() || ticks.at.size() >= 200) return;
    // The last one, which names the axis, is there in any case. The first of one axis is where that
    // of the other is.
    QRectF last;
    for (std::size_t i = ticks.at.size(); i-- > (*axis == 'y' ? 1U : 0U);) {
      QString text = QString::fromStdString(picture::tick_label(ticks.at[i], step));
      if (i + 1 == ticks.at.size()) text = axis + QString(" = ") + text + " m";
      const QRectF box = box_of_number(place(ticks.at[i]), away, text);
      if (box.isEmpty() || box.adjusted(-6.0, 0.0, 6.0, 0.0).intersects(last) ||
          box.intersects(taken)) {
        continue;
      }
      painter_.drawText(box, Qt::AlignCenter, text);
      last = box;
    }
  };
  along(
      x,
      [&](double at) {
        return Vector3{at, south * (y + aside), 0.0};
      },
      {0.0, south, 0.0}, "x");
  along(
      y,
      [&](double at) {
        return Vector3{west * (x + aside), at, 0.0};
      },
      {west, 0.0, 0.0}, "y");
  painter_.setFont(before);
}

QRectF OverlayPainter::box_of_number(const Vector3& at, const Vector3& away,
                                     const QString& text) const {
  const Vector3 top{0.0, 0.0, stage_.height()};
  auto begin = camera_.project(at, size_);
  const auto end = camera_.project(at + 0.1 * away, size_),
             above = camera_.project(at + top, size_);
  if (!begin || !end || !above || !QRectF(QPointF(), QSizeF(size_)).contains(*begin)) return {};
  const QFontMetricsF metrics(painter_.font());
  const double wide = metrics.horizontalAdvance(text), high = metrics.height();
  QPointF way = *end - *begin;
  way /= std::max(1e-6, std::hypot(way.x(), way.y()));
  // Beyond the top of a wall that leans outwards in the picture.
  *begin += std::max(0.0, QPointF::dotProduct(*above - *begin, way)) * way;
  // The box touches the edge with the side that is nearest to it.
  const QPointF middle = *begin + QPointF(0.5 * wide * way.x(), 0.5 * high * way.y());
  return {middle - QPointF(0.5 * wide, 0.5 * high), QSizeF(wide + 1.0, high)};
}

void OverlayPainter::sketches() const {
  for (const snapshots::MarkState& mark : stage_.marks()) {
    const render::SketchStyle& style = render::style_of(mark.role);
    painter_.setPen(QPen(colour_of(style.colour, style.opacity), style.width));
    switch (mark.kind) {
      case Sketch::Kind::points:
        point(mark.begin(), mark.role);
        break;
      case Sketch::Kind::line:
        break;
      case Sketch::Kind::arrow:
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

void OverlayPainter::rings() const {
  constexpr double kLeast = 8.0, kRadius = 7.0, kTip = 4.0;  // px
  for (const Stage::Body& body : stage_.bodies()) {
    const Stage::Solid* chassis =
        body.is_present && body.is_robot() ? stage_.chassis_of(body) : nullptr;
    if (!chassis) continue;
    const Vector3& size = chassis->shape.size;
    const double half = 0.5 * std::max(size.x, size.y);
    const auto at = camera_.project(body.frame.origin, size_);
    const auto side = camera_.project(body.frame.origin + half * camera_.frame().left, size_);
    const auto front = camera_.project(body.frame.point({half, 0.0, 0.0}), size_);
    if (!at || !side || !front || 2.0 * QLineF(*at, *side).length() >= kLeast) continue;
    const QColor colour = colour_of(body.colour);
    painter_.setPen(QPen(Qt::white, 3.5));
    painter_.drawEllipse(*at, kRadius, kRadius);
    painter_.setPen(QPen(colour, 2.0));
    painter_.drawEllipse(*at, kRadius, kRadius);
    QLineF heading(*at, *front);
    if (heading.length() < 1e-3) continue;
    heading.setLength(kRadius + kTip);
    painter_.drawLine(QLineF(heading.pointAt(kRadius / (kRadius + kTip)), heading.p2()));
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
    painter_.setBrush(colour_of(render::style_of(role).colour, render::style_of(role).opacity));
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

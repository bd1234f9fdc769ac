// What is selected in the view: where hands hold it, and how that is drawn.
#include <QLineF>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "paint/padlock.h"
#include "scene/overlay_painter.h"
#include "scene/scene_view.h"

namespace elsie::desktop {
namespace {

constexpr double kHandle = 8.0;     // px, radius
constexpr double kReach = 11.0;     // px, from the middle of a handle
constexpr double kKnobAway = 30.0;  // px, from the edge of the thing

const QColor kSelected(0xe0, 0x80, 0x00);

}  // namespace

std::optional<Frame> SceneView::frame_of_selected() const {
  return stage_.place_of(selection_.value(0));
}

// Only obstacles, resources and patches have a size that the view can change; a line, of several
// pieces, has none.
std::optional<Vector3> SceneView::size_of_selected() const {
  const QString path = selection_.value(0);
  if (path.isEmpty() || path.startsWith("robot") || path.startsWith("charger") ||
      path.startsWith("lamp")) {
    return std::nullopt;
  }
  const auto& solids = stage_.solids();
  if (Stage::is_patch(path) && std::count_if(solids.begin(), solids.end(), [&](const auto& each) {
                                 return each.path == path;
                               }) > 1) {
    return std::nullopt;
  }
  const Stage::Solid* solid = stage_.solid_of(path);
  return solid ? std::optional(solid->shape.size) : std::nullopt;
}

std::optional<QPointF> SceneView::handle(Tool tool) const {
  const auto at = place_of_handle(tool);
  if (tool != Tool::resize || !at) return at;
  for (const Tool other : {Tool::move, Tool::turn}) {
    const auto beside = place_of_handle(other);
    if (beside && QLineF(*beside, *at).length() < 2.0 * kReach) return std::nullopt;
  }
  return at;
}

std::optional<QPointF> SceneView::place_of_handle(Tool tool) const {
  const auto frame = frame_of_selected();
  if (!frame || locked_.contains(selection_.front())) {
    return std::nullopt;
  }
  const Vector3 foot{frame->origin.x, frame->origin.y, 0.0};
  const auto at = camera_.project(foot, size());
  if (!at || tool == Tool::move) {
    return at;
  }
  double radius = 0.0;
  for (const Stage::Solid& solid : stage_.solids()) {
    if (solid.path == selection_.front()) {
      radius = std::max(radius, 0.5 * std::hypot(solid.shape.size.x, solid.shape.size.y));
    }
  }
  if (tool == Tool::turn) {
    const auto edge = camera_.project(foot + radius * frame->forward, size());
    if (!edge) return std::nullopt;
    QPointF way = *edge - *at;
    const double length = std::hypot(way.x(), way.y());
    way = length > 1e-6 ? way / length : QPointF(0.0, -1.0);
    return *edge + kKnobAway * way;
  }
  const auto sides = size_of_selected();
  return tool == Tool::resize && sides
             ? camera_.project(
                   foot + 0.5 * sides->x * frame->forward + 0.5 * sides->y * frame->left, size())
             : std::nullopt;
}

std::optional<SceneView::Tool> SceneView::handle_at(const QPointF& pixel, double* height) const {
  for (const Tool tool : {Tool::resize, Tool::turn, Tool::move}) {
    if (const auto at = handle(tool); at && QLineF(*at, pixel).length() <= kReach) {
      return tool;
    }
  }
  const Vector3 from = camera_.frame().origin, direction = camera_.ray(pixel, size());
  double way = 0.0;
  if (!movable().contains(stage_.at(from, direction, &way))) return std::nullopt;
  if (height) *height = from.z + way * direction.z;
  return Tool::move;
}

// The selected objects that have a place and are not locked.
QStringList SceneView::movable() const {
  QStringList paths;
  for (const QString& path : selection_) {
    if (!locked_.contains(path) && stage_.place_of(path)) {
      paths << path;
    }
  }
  return paths;
}

void SceneView::paint_selection(QPainter& painter, const OverlayPainter& over) const {
  const bool is_dragged = is_selection_dragged();
  for (const QString& path : selection_) {
    const bool is_moved = is_dragged && !locked_.contains(path);
    if (const Stage::Body* body = stage_.body_of(path)) paint_coverage(painter, over, *body);
    for (const Stage::Solid& solid : stage_.solids()) {
      if (solid.path != path || !stage_.is_present(solid) ||
          std::min({solid.shape.size.x, solid.shape.size.y}) < 0.005) {
        continue;
      }
      painter.setPen(QPen(kSelected, 1.5));
      for (const auto& [from, to] : edges_of(solid, stage_.frame_of(solid))) {
        over.line(from, to);
      }
      if (is_moved) {
        paint_ghost(painter, over, solid);
      }
    }
  }
  if (is_dragged) {
    return;
  }
  paint_handles(painter);
}

/// A dashed circle on the floor, within which the robot perceives its team.
void SceneView::paint_coverage(QPainter& painter, const OverlayPainter& over,
                               const Stage::Body& body) const {
  if (!body.is_present || body.coverage <= 0.0) {
    return;
  }
  constexpr int kDashes = 60;
  painter.setPen(QPen(kSelected, 1.0));
  const auto place = [&](double dash) {
    const double angle = 2.0 * std::numbers::pi * dash / kDashes;
    return Vector3{body.frame.origin.x + body.coverage * std::cos(angle),
                   body.frame.origin.y + body.coverage * std::sin(angle), 0.0};
  };
  for (int dash = 0; dash < kDashes; ++dash) over.line(place(dash), place(dash + 0.5));
}

/// What a hand drags, but for the body itself: nothing is drawn over that. A thing that is small on
/// the screen has a ring around it.
void SceneView::paint_handles(QPainter& painter) const {
  const auto foot = handle(Tool::move), knob = handle(Tool::turn), corner = handle(Tool::resize);
  if (!foot) return;
  painter.setBrush(Qt::NoBrush);
  if (!corner && knob && QLineF(*foot, *knob).length() < kKnobAway + 2.0 * kReach) {
    painter.setPen(QPen(kSelected, 1.5));
    painter.drawEllipse(*foot, 1.5 * kReach, 1.5 * kReach);
  }
  painter.setBrush(kSelected);
  if (knob) {
    painter.setPen(QPen(kSelected, 1.2));
    const QPointF way = (*knob - *foot) / std::max(1.0, QLineF(*foot, *knob).length());
    painter.drawLine(*knob - (kKnobAway - 4.0) * way, *knob);
    painter.setPen(QPen(Qt::white, 1.5));
    painter.drawEllipse(*knob, kHandle - 2.0, kHandle - 2.0);
  }
  if (corner) {
    painter.drawRect(QRectF(*corner - QPointF(6.0, 6.0), QSizeF(12.0, 12.0)));
  }
  painter.setBrush(Qt::NoBrush);
}

void SceneView::paint_locks(QPainter& painter) const {
  const double side = QFontMetricsF(font()).height();
  for (const QString& path : locked_) {
    const auto frame = stage_.place_of(path);
    const auto at =
        frame ? camera_.project({frame->origin.x, frame->origin.y, 0.0}, size()) : std::nullopt;
    if (at) {
      const QRectF area(at->x() + 0.8 * side, at->y(), side, side);  // the object stays visible
      painter.setPen(Qt::NoPen);
      painter.setBrush(QColor(255, 255, 255, 215));
      painter.drawEllipse(area.adjusted(-3.0, -3.0, 3.0, 3.0));
      draw_padlock(painter, area, QColor(25, 25, 25));
    }
  }
  painter.setBrush(Qt::NoBrush);
}

// Draws the object where it will be.
void SceneView::paint_ghost(QPainter& painter, const OverlayPainter& over,
                            const Stage::Solid& solid) const {
  Stage::Solid shown = solid;
  Frame ghost = stage_.frame_of(solid);
  if (ghost_.size) {
    shown.shape = elsie::resized(solid.shape, ghost_.size->x, ghost_.size->y);
  }
  if (ghost_.turn != 0.0) {
    if (const Stage::Body* body = stage_.body_of(solid.path)) {
      ghost = Frame::turned(body->frame.origin, heading_rad(body->frame) + ghost_.turn, 0.0)
                  .frame(solid.frame);
    }
  }
  ghost.origin = ghost.origin + Vector3{ghost_.x, ghost_.y, 0.0};
  painter.setPen(QPen(kSelected, 1.2, Qt::DashLine));
  for (const auto& [from, to] : edges_of(shown, ghost)) {
    over.line(from, to);
  }
}

void SceneView::paint_tape(QPainter& painter, const OverlayPainter& over) const {
  if (!tape_) {
    return;
  }
  const auto& [from, to] = *tape_;
  painter.setPen(QPen(QColor(20, 20, 20), 1.6));
  over.line(from, to);
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const double angle = degrees(std::atan2(to.y - from.y, to.x - from.x));
  if (const auto at = camera_.project(0.5 * (from + to), size())) {
    over.note(*at + QPointF(6.0, -2.0),
              tr("%1 m, %2\u00b0").arg(length, 0, 'f', 3).arg(angle, 0, 'f', 1));
  }
}

}  // namespace elsie::desktop

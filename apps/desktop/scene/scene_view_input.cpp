// Mouse and keys in the view.
#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "scene/scene_view.h"

namespace elsie::desktop {
namespace {

constexpr double kClick = 4.0;       // px: a press with less movement is a click
constexpr double kSnap = 0.1;        // m
constexpr double kSnapTurn = 15.0;   // degrees
constexpr double kFine = 0.2;        // with Shift: the part of the mouse's movement that counts
constexpr double kFineStep = 0.01;   // m, by keys with Shift
constexpr double kLeastSize = 0.02;  // m
constexpr double kWheel = 0.0015;    // of a zoom, in eighths of a degree

}  // namespace

void SceneView::mousePressEvent(QMouseEvent* event) {
  setFocus();
  if (drag_ != Drag::none) {
    typed_.is_on() && event->button() == Qt::LeftButton ? end_drag() : stop_drag();
    return;
  }
  pressed_ = last_ = event->position();
  button_ = event->button();
  const auto floor = camera_.on_plane(pressed_, size());
  pressed_at_ = floor.value_or(Vector3{});
  held_height_ = 0.0;
  drag_ = Drag::pressed;
  if (button_ == Qt::LeftButton && !(event->modifiers() & Qt::ControlModifier) && floor) {
    if (tool_ == Tool::measure) {
      drag_ = Drag::tool;
      dragged_ = Tool::measure;
      tape_ = {pressed_at_, pressed_at_};
    } else if (const auto handle = handle_at(pressed_, &held_height_)) {
      drag_ = Drag::tool;
      dragged_ = *handle;
      ghost_ = {};
      pressed_at_ = camera_.on_plane(pressed_, size(), held_height_).value_or(pressed_at_);
    }
  }
  update();
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  if (drag_ == Drag::none) {
    if (tool_ != Tool::measure) {
      setCursor(handle_at(at) ? Qt::SizeAllCursor : Qt::ArrowCursor);
    }
    return;
  }
  if (drag_ == Drag::pressed && QLineF(at, pressed_).length() >= kClick) {
    const bool pans = button_ == Qt::RightButton || button_ == Qt::MiddleButton;
    drag_ = pans ? Drag::pan : Drag::orbit;
    // Who takes the camera leaves the robot's place.
    if (pans || camera_.seat) {
      follow({});
    }
  }
  const QPointF by = at - last_;
  last_ = at;
  if (drag_ == Drag::orbit) {
    camera_.orbit(by);
    camera_moved();
  } else if (drag_ == Drag::pan) {
    camera_.pan(by, size());
    camera_moved();
  } else if (drag_ != Drag::pressed) {
    drag_to(at, event->modifiers());
  }
}

void SceneView::drag_to(const QPointF& pixel, Qt::KeyboardModifiers modifiers) {
  if (typed_.has_number()) {
    return;
  }
  const auto floor = camera_.on_plane(pixel, size(), held_height_);
  const auto frame = frame_of_selected();
  if (!floor) {
    return;
  }
  const bool snaps = modifiers & Qt::ControlModifier;
  const double part = modifiers & Qt::ShiftModifier ? kFine : 1.0;
  const auto snapped = [&](double value, double step) {
    return snaps ? std::round(value / step) * step : value;
  };
  if (dragged_ == Tool::measure) {
    tape_->second = {snapped(floor->x, kSnap), snapped(floor->y, kSnap), 0.0};
  } else if (frame && dragged_ == Tool::move) {
    const Vector3 foot = frame->origin;
    ghost_.x = snapped(foot.x + part * (floor->x - pressed_at_.x), kSnap) - foot.x;
    ghost_.y = snapped(foot.y + part * (floor->y - pressed_at_.y), kSnap) - foot.y;
  } else if (frame && dragged_ == Tool::turn) {
    const double heading = heading_rad(*frame);
    const double wanted = std::atan2(floor->y - frame->origin.y, floor->x - frame->origin.x);
    const double by = part * wrap_angle(wanted - heading);
    ghost_.turn = radians(snapped(degrees(heading + by), kSnapTurn)) - heading;
  } else if (frame && dragged_ == Tool::resize) {
    const Vector3 aside = *floor - frame->origin;
    ghost_.size =
        Vector3{std::max(kLeastSize, snapped(2.0 * std::abs(dot(aside, frame->forward)), kSnap)),
                std::max(kLeastSize, snapped(2.0 * std::abs(dot(aside, frame->left)), kSnap)), 0.0};
  }
  update();
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != button_ || drag_ == Drag::none || typed_.is_on()) {
    return;
  }
  const bool is_click =
      drag_ == Drag::pressed ||
      (is_selection_dragged() && QLineF(event->position(), pressed_).length() < kClick);
  if (!is_click) {
    end_drag();
    return;
  }
  stop_drag();
  const QString path = stage_.at(camera_.frame().origin, camera_.ray(event->position(), size()));
  if (button_ == Qt::LeftButton) {
    QStringList paths;
    if (event->modifiers() & Qt::ShiftModifier) {
      paths = selection_;
      if (!path.isEmpty() && !paths.removeOne(path)) {
        paths << path;
      }
    } else if (!path.isEmpty()) {
      paths << path;
    }
    set_selection(paths);
    Q_EMIT selected(paths);
  } else if (button_ == Qt::RightButton) {
    if (!path.isEmpty()) {
      set_selection({path});
      Q_EMIT selected({path});
      Q_EMIT edit_wished(path);
    } else {
      const Vector3 at = camera_.on_plane(event->position(), size()).value_or(Vector3{});
      Q_EMIT menu_wished(event->globalPosition().toPoint(), QPointF(at.x, at.y));
    }
  }
}

void SceneView::end_drag() {
  const Tool dragged = drag_ == Drag::tool ? dragged_ : Tool::none;
  drag_ = Drag::none;
  if (dragged == Tool::move && (ghost_.x != 0.0 || ghost_.y != 0.0)) {
    Q_EMIT moved(movable(), ghost_.x, ghost_.y);
  } else if (dragged == Tool::turn && ghost_.turn != 0.0) {
    Q_EMIT turned(selection_.front(), ghost_.turn);
  } else if (dragged == Tool::resize && ghost_.size) {
    Q_EMIT resized(selection_.front(), ghost_.size->x, ghost_.size->y);
  } else if (dragged == Tool::measure) {
    Q_EMIT measured(tape_->first.x, tape_->first.y, tape_->second.x, tape_->second.y);
  }
  ghost_ = {};
  typed_.end();
  update();
}

void SceneView::stop_drag() {
  drag_ = Drag::none;
  ghost_ = {};
  typed_.end();
  update();
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
  const QString path = stage_.at(camera_.frame().origin, camera_.ray(event->position(), size()));
  if (event->button() == Qt::LeftButton && path.startsWith("robot[")) {
    follow(followed_ == path ? QString() : path);
  }
}

void SceneView::wheelEvent(QWheelEvent* event) {
  camera_.zoom(std::exp(-kWheel * event->angleDelta().y()), event->position(), size());
  camera_moved();
  event->accept();
}

void SceneView::begin_typed(Tool tool) {
  const auto frame = frame_of_selected();
  if (!frame || drag_ != Drag::none || locked_.contains(selection_.front())) {
    return;
  }
  if (tool == Tool::resize && !size_of_selected()) {
    Q_EMIT said(tr("The view cannot resize this; its numbers are in Properties."));
    return;
  }
  typed_.begin(tool);
  ghost_ = {};
  drag_ = Drag::tool;
  dragged_ = tool;
  held_height_ = 0.0;
  pressed_at_ = camera_.on_plane(mapFromGlobal(QCursor::pos()), size()).value_or(frame->origin);
  update();
}

void SceneView::take_typed(const QKeyEvent& key) {
  if (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter) {
    end_drag();
    return;
  }
  if (!typed_.take(key)) {
    return;
  }
  ghost_ = {};
  const double number = typed_.has_number() ? typed_.number() : 0.0;
  const TypedDrag::Axis axis = typed_.axis();
  if (dragged_ == Tool::move) {
    (axis == TypedDrag::Axis::y ? ghost_.y : ghost_.x) = number;
  } else if (dragged_ == Tool::turn) {
    ghost_.turn = radians(number);
  } else if (const auto sides = size_of_selected(); sides && number > 0.0) {
    ghost_.size = Vector3{axis == TypedDrag::Axis::y ? sides->x : number * sides->x,
                          axis == TypedDrag::Axis::x ? sides->y : number * sides->y, 0.0};
  }
  update();
}

// A right click is handled on release, because it may become a drag.
void SceneView::contextMenuEvent(QContextMenuEvent* event) {
  if (event->reason() == QContextMenuEvent::Mouse) {
    return;
  }
  const auto at = handle(Tool::move);
  Q_EMIT element_menu_wished(selection_.value(0),
                             mapToGlobal(at ? at->toPoint() : rect().center()));
}

bool SceneView::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && typed_.is_on()) {
    event->accept();  // the view uses Enter and numbers now
    return true;
  }
  if (event->type() == QEvent::PaletteChange) {
    is_stale_ = true;  // dark or light
  }
  return QWidget::event(event);
}

void SceneView::keyPressEvent(QKeyEvent* event) {
  if (typed_.is_on() && event->key() != Qt::Key_Escape) {
    take_typed(*event);
    return;
  }
  const double step = event->modifiers() & Qt::ShiftModifier ? kFineStep : kSnap;
  const auto nudge = [&](double x, double y) {
    if (!movable().isEmpty()) {
      Q_EMIT moved(movable(), x * step, y * step);
    }
  };
  switch (event->key()) {
    case Qt::Key_Escape:
      if (camera_.seat) follow({});
      stop_drag();
      set_tool(Tool::move);
      break;
    case Qt::Key_Space:
      if (!event->isAutoRepeat()) {
        Q_EMIT run_wished();
      }
      break;
    case Qt::Key_G:
      begin_typed(Tool::move);
      break;
    case Qt::Key_R:
      begin_typed(Tool::turn);
      break;
    case Qt::Key_S:
      begin_typed(Tool::resize);
      break;
    case Qt::Key_Left:
      nudge(-1.0, 0.0);
      break;
    case Qt::Key_Right:
      nudge(1.0, 0.0);
      break;
    case Qt::Key_Up:
      nudge(0.0, 1.0);
      break;
    case Qt::Key_Down:
      nudge(0.0, -1.0);
      break;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace elsie::desktop

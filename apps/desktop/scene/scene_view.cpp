#include "scene/scene_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>

#include "elsie/render/renderer.h"

namespace elsie::desktop {
namespace {

constexpr double kClick = 4.0;       // px: a press that moves less is a click
constexpr double kHandle = 8.0;      // px, radius
constexpr double kKnobAway = 30.0;   // px, from the edge of the thing
constexpr double kSnap = 0.1;        // m
constexpr double kSnapTurn = 15.0;   // degrees
constexpr double kFine = 0.2;        // of the way of the mouse, with Shift
constexpr double kLeastSize = 0.02;  // m
constexpr double kWheel = 0.0015;    // of a zoom, in eighths of a degree

const QColor kSelected(0xe0, 0x80, 0x00);
const QColor kBeam(0x2a, 0x7a, 0xb8, 110);
const QColor kHit(0xc0, 0x30, 0x30, 190);
const QColor kGrid(0, 0, 0, 28);
const QColor kView(0x80, 0x60, 0xb0, 110);

QColor colour_of(const Colour& colour) { return {colour.red, colour.green, colour.blue}; }

double heading_of(const Frame& frame) { return std::atan2(frame.forward.y, frame.forward.x); }

Vector3 vector_of(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

/// A length that divides a picture into about ten parts: 1, 2 or 5 times a power of ten.
double grid_step(double length) {
  const double rough = length / 10.0;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double digit = rough / power;
  return power * (digit < 1.5 ? 1.0 : digit < 3.5 ? 2.0 : digit < 7.5 ? 5.0 : 10.0);
}

}  // namespace

SceneView::SceneView(QWidget* parent) : QWidget(parent) {
  setObjectName("scene");
  setAccessibleName(tr("World"));
  setAccessibleDescription(tr(
      "The world from the camera. All things are also in the tree, with their places as numbers."));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(160, 120);
  setAttribute(Qt::WA_OpaquePaintEvent);
  try {
    renderer_ = std::make_unique<render::Renderer>();
  } catch (const render::RenderError&) {
    has_no_renderer_ = true;  // outlines by Qt
  }
}

SceneView::~SceneView() = default;

QString SceneView::device() const {
  return renderer_ ? QString::fromStdString(renderer_->device()) : QString();
}

// What there is

void SceneView::set_scene(const Json& scene, std::uint64_t epoch) {
  const double length = stage_.length(), width = stage_.width();
  stage_.set_scene(scene, epoch);
  views_ = scene.is_object() ? scene.value("views", Json::array()) : Json::array();
  if (!was_shown_ || length != stage_.length() || width != stage_.width()) {
    was_shown_ = !stage_.is_empty();
    show_all();
  }
  stop_drag();
  camera_moved();
}

void SceneView::take(const snapshots::Snapshot& snapshot) {
  if (!stage_.take(snapshot)) {
    return;
  }
  trails_.note(stage_);
  if (const Stage::Body* body = followed_.isEmpty() ? nullptr : stage_.body_of(followed_)) {
    camera_.target = {body->frame.origin.x, body->frame.origin.y, 0.0};
    trails_.paint_anew();
  }
  is_stale_ = true;
  update();
}

void SceneView::clear_trails() {
  trails_.clear();
  update();
}

void SceneView::set_selection(const QStringList& paths) {
  if (paths != selection_) {
    selection_ = paths;
    stop_drag();
    update();
  }
}

void SceneView::set_tool(Tool tool) {
  tool_ = tool;
  setCursor(tool == Tool::measure ? Qt::CrossCursor : Qt::ArrowCursor);
  if (tool != Tool::measure) {
    tape_.reset();
  }
  update();
}

// The camera

void SceneView::camera_moved() {
  is_stale_ = true;
  trails_.paint_anew();
  update();
  Q_EMIT camera_changed();
}

void SceneView::show_all() {
  camera_.show(std::max(0.1, stage_.length()), std::max(0.1, stage_.width()), size());
  camera_moved();
}

void SceneView::look_from_top() {
  camera_.look_from_top();
  camera_moved();
}

void SceneView::look_from_front() {
  camera_.look_from_front();
  camera_moved();
}

void SceneView::look_from_side() {
  camera_.look_from_side();
  camera_moved();
}

void SceneView::frame_selection() {
  if (const auto frame = frame_of_selected()) {
    camera_.target = {frame->origin.x, frame->origin.y, 0.0};
    camera_.distance = std::min(camera_.distance, std::max(0.6, 0.15 * stage_.length()));
    camera_moved();
  } else {
    show_all();
  }
}

void SceneView::follow(const QString& path) {
  followed_ = path;
  if (const Stage::Body* body = path.isEmpty() ? nullptr : stage_.body_of(path)) {
    camera_.target = {body->frame.origin.x, body->frame.origin.y, 0.0};
    camera_moved();
  }
}

// Painting

void SceneView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (!event->oldSize().isValid()) {
    show_all();
  }
  is_stale_ = true;
}

void SceneView::draw_solids() {
  is_stale_ = false;
  const double ratio = devicePixelRatioF();
  const int width = std::max(1, static_cast<int>(this->width() * ratio));
  const int height = std::max(1, static_cast<int>(this->height() * ratio));
  if (!renderer_) {
    return;
  }
  render::View view{camera_.frame(), {width, height, OrbitCamera::kFov}};
  Image* const pictures[] = {&pixels_};
  try {
    renderer_->render(stage_.drawn(), std::span(&view, 1), pictures);
  } catch (const render::RenderError&) {
    renderer_.reset();
    has_no_renderer_ = true;
    return;
  }
  drawn_ = QImage(pixels_.bytes.data(), width, height, static_cast<qsizetype>(width) * 3,
                  QImage::Format_RGB888);
  drawn_.setDevicePixelRatio(ratio);
}

void SceneView::paintEvent(QPaintEvent*) {
  if (is_stale_) {
    draw_solids();
  }
  QPainter painter(this);
  paint(painter, true);
}

QImage SceneView::picture() {
  draw_solids();
  QImage image(size() * devicePixelRatioF(), QImage::Format_RGB32);
  image.setDevicePixelRatio(devicePixelRatioF());
  QPainter painter(&image);
  paint(painter, false);
  return image;
}

void SceneView::paint(QPainter& painter, bool with_handles) {
  if (renderer_ && !drawn_.isNull()) {
    painter.drawImage(QPoint(0, 0), drawn_);
  } else {
    painter.fillRect(rect(), QColor(226, 228, 224));
  }
  painter.setRenderHint(QPainter::Antialiasing);
  if (stage_.is_empty()) {
    return;
  }
  if (has_no_renderer_) {
    paint_outlines(painter);
  }
  if (overlays_.grid) paint_grid(painter);
  if (overlays_.trails) trails_.paint(painter, camera_, size(), devicePixelRatioF());
  if (overlays_.views) paint_views(painter);
  if (overlays_.beams) paint_beams(painter);
  if (overlays_.names) paint_names(painter);
  if (with_handles) {
    paint_selection(painter);
    paint_tape(painter);
    paint_typed(painter);
  }
}

void SceneView::line(QPainter& painter, const Vector3& from, const Vector3& to) const {
  // A line that ends behind the camera is cut where it passes the camera's plane.
  const Frame eye = camera_.frame();
  Vector3 a = from, b = to;
  const double ahead_a = dot(a - eye.origin, eye.forward),
               ahead_b = dot(b - eye.origin, eye.forward);
  constexpr double kNear = 0.02;
  if (ahead_a < kNear && ahead_b < kNear) {
    return;
  }
  if (ahead_a < kNear) a = a + ((kNear - ahead_a) / (ahead_b - ahead_a)) * (b - a);
  if (ahead_b < kNear) b = b + ((kNear - ahead_b) / (ahead_a - ahead_b)) * (a - b);
  const auto begin = camera_.project(a, size()), end = camera_.project(b, size());
  if (begin && end) {
    painter.drawLine(*begin, *end);
  }
}

void SceneView::paint_outlines(QPainter& painter) {
  for (const Stage::Solid& solid : stage_.solids()) {
    if (stage_.is_present(solid)) {
      painter.setPen(QPen(colour_of(solid.colour).darker(120), 1.5));
      for (const auto& [from, to] : edges_of(solid.shape, stage_.frame_of(solid))) {
        line(painter, from, to);
      }
    }
  }
}

void SceneView::paint_grid(QPainter& painter) const {
  painter.setPen(QPen(kGrid, 1.0));
  const double x = 0.5 * stage_.length(), y = 0.5 * stage_.width();
  const double step = grid_step(std::max(stage_.length(), stage_.width()));
  for (double at = std::ceil(-x / step) * step; at <= x + 1e-9; at += step) {
    line(painter, {at, -y, 0.0}, {at, y, 0.0});
  }
  for (double at = std::ceil(-y / step) * step; at <= y + 1e-9; at += step) {
    line(painter, {-x, at, 0.0}, {x, at, 0.0});
  }
}

void SceneView::paint_beams(QPainter& painter) const {
  for (const snapshots::BeamState& beam : stage_.beams()) {
    painter.setPen(QPen(beam.hit ? kHit : kBeam, 1.0));
    line(painter, {beam.from[0], beam.from[1], beam.from[2]}, {beam.to[0], beam.to[1], beam.to[2]});
  }
}

// The pyramid that a camera sees.
void SceneView::paint_views(QPainter& painter) const {
  for (const Json& each : views_) {
    const auto body = static_cast<std::size_t>(each.value("body", 0));
    if (body >= stage_.bodies().size() || !stage_.bodies()[body].is_present) {
      continue;
    }
    const Json& json = each.at("frame");
    const Frame frame =
        stage_.bodies()[body].frame.frame({vector_of(json.at(0)), vector_of(json.at(1)),
                                           vector_of(json.at(2)), vector_of(json.at(3))});
    const double range = each.value("range", 0.5);
    const double aside = range * std::tan(0.5 * each.value("fov_rad", 0.5));
    const double above = aside * each.value("height", 100.0) / each.value("width", 100.0);
    const std::array<Vector3, 4> corners{
        frame.point({range, aside, above}), frame.point({range, -aside, above}),
        frame.point({range, -aside, -above}), frame.point({range, aside, -above})};
    painter.setPen(QPen(kView, 1.0));
    for (std::size_t i = 0; i < 4; ++i) {
      line(painter, frame.origin, corners[i]);
      line(painter, corners[i], corners[(i + 1) % 4]);
    }
  }
}

void SceneView::paint_names(QPainter& painter) const {
  const QFontMetricsF metrics(font());
  for (const Stage::Body& body : stage_.bodies()) {
    if (!body.is_present || !body.is_robot()) {
      continue;
    }
    const QString name = body.path.mid(6, body.path.size() - 7);
    if (const auto at = camera_.project(body.frame.point({0.0, 0.0, 0.15}), size())) {
      const double width = metrics.horizontalAdvance(name);
      const QRectF box(at->x() - 0.5 * width - 3.0, at->y() - metrics.height() - 6.0, width + 6.0,
                       metrics.height());
      painter.setPen(Qt::NoPen);
      painter.setBrush(QColor(255, 255, 255, 170));
      painter.drawRoundedRect(box, 3.0, 3.0);
      painter.setPen(QColor(30, 30, 30));
      painter.drawText(box, Qt::AlignCenter, name);
    }
  }
  painter.setBrush(Qt::NoBrush);
}

std::optional<Frame> SceneView::frame_of_selected() const {
  if (selection_.isEmpty()) {
    return std::nullopt;
  }
  if (const Stage::Body* body = stage_.body_of(selection_.front())) {
    return body->is_present ? std::optional(body->frame) : std::nullopt;
  }
  for (const Stage::Solid& solid : stage_.solids()) {
    if (solid.path == selection_.front()) {
      Frame frame = stage_.frame_of(solid);
      frame.origin.z = 0.0;
      return frame;
    }
  }
  return std::nullopt;
}

// Only boxes have a size of their own.
std::optional<Vector3> SceneView::size_of_selected() const {
  const QString path = selection_.value(0);
  if (path.isEmpty() || path.startsWith("robot") || path.startsWith("charger")) {
    return std::nullopt;
  }
  for (const Stage::Solid& solid : stage_.solids()) {
    if (solid.path == path) {
      return solid.shape.size;
    }
  }
  return std::nullopt;
}

std::optional<QPointF> SceneView::handle(Tool tool) const {
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

std::optional<SceneView::Tool> SceneView::handle_at(const QPointF& pixel) const {
  for (const Tool tool : {Tool::resize, Tool::turn, Tool::move}) {
    if (const auto at = handle(tool); at && QLineF(*at, pixel).length() <= kHandle + 3.0) {
      return tool;
    }
  }
  return std::nullopt;
}

void SceneView::paint_selection(QPainter& painter) const {
  const bool is_dragged = drag_ == Drag::move || drag_ == Drag::turn || drag_ == Drag::resize;
  for (const QString& path : selection_) {
    for (const Stage::Solid& solid : stage_.solids()) {
      if (solid.path != path || !stage_.is_present(solid) ||
          std::min({solid.shape.size.x, solid.shape.size.y}) < 0.005) {
        continue;
      }
      const Frame frame = stage_.frame_of(solid);
      painter.setPen(QPen(kSelected, 1.5));
      for (const auto& [from, to] : edges_of(solid.shape, frame)) {
        line(painter, from, to);
      }
      if (!is_dragged) {
        continue;
      }
      // Where it will be.
      Shape shape = solid.shape;
      Frame ghost = frame;
      if (ghost_.size) {
        shape.size.x = ghost_.size->x;
        shape.size.y = ghost_.size->y;
      }
      if (ghost_.turn != 0.0) {
        if (const Stage::Body* body = stage_.body_of(path)) {
          const Frame turned =
              Frame::turned(body->frame.origin, heading_of(body->frame) + ghost_.turn, 0.0);
          ghost = turned.frame(solid.frame);
        }
      }
      ghost.origin = ghost.origin + Vector3{ghost_.x, ghost_.y, 0.0};
      painter.setPen(QPen(kSelected, 1.2, Qt::DashLine));
      for (const auto& [from, to] : edges_of(shape, ghost)) {
        line(painter, from, to);
      }
    }
  }
  if (is_dragged) {
    return;
  }
  painter.setPen(QPen(Qt::white, 1.5));
  painter.setBrush(kSelected);
  if (const auto knob = handle(Tool::turn)) {
    painter.setPen(QPen(kSelected, 1.2));
    painter.drawLine(*handle(Tool::move), *knob);
    painter.setPen(QPen(Qt::white, 1.5));
    painter.drawEllipse(*knob, kHandle - 2.0, kHandle - 2.0);
  }
  if (const auto corner = handle(Tool::resize)) {
    painter.drawRect(QRectF(*corner - QPointF(6.0, 6.0), QSizeF(12.0, 12.0)));
  }
  if (const auto foot = handle(Tool::move)) {
    painter.setBrush(QColor(kSelected.red(), kSelected.green(), kSelected.blue(), 120));
    painter.drawEllipse(*foot, kHandle, kHandle);
    painter.drawLine(*foot - QPointF(5.0, 0.0), *foot + QPointF(5.0, 0.0));
    painter.drawLine(*foot - QPointF(0.0, 5.0), *foot + QPointF(0.0, 5.0));
  }
  painter.setBrush(Qt::NoBrush);
}

void SceneView::paint_tape(QPainter& painter) const {
  if (!tape_) {
    return;
  }
  const auto& [from, to] = *tape_;
  painter.setPen(QPen(QColor(20, 20, 20), 1.6));
  line(painter, from, to);
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const double angle = degrees(std::atan2(to.y - from.y, to.x - from.x));
  if (const auto at = camera_.project(0.5 * (from + to), size())) {
    const QString text = tr("%1 m, %2\u00b0").arg(length, 0, 'f', 3).arg(angle, 0, 'f', 1);
    const QRectF box(at->x() + 6.0, at->y() - 20.0,
                     QFontMetricsF(font()).horizontalAdvance(text) + 8.0, 18.0);
    painter.fillRect(box, QColor(255, 255, 255, 210));
    painter.drawText(box, Qt::AlignCenter, text);
  }
}

void SceneView::paint_typed(QPainter& painter) const {
  if (!typed_.is_on()) {
    return;
  }
  const QString text = tr("%1   (Enter: do it, Esc: leave it)").arg(typed_.text());
  const QFontMetricsF metrics(font());
  const QRectF box(8.0, height() - 2.2 * metrics.height(), metrics.horizontalAdvance(text) + 12.0,
                   1.6 * metrics.height());
  painter.fillRect(box, QColor(255, 255, 255, 220));
  painter.setPen(QColor(20, 20, 20));
  painter.drawText(box, Qt::AlignCenter, text);
}

// Mouse and keys

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
  drag_ = Drag::pressed;
  if (button_ == Qt::LeftButton && !(event->modifiers() & Qt::ControlModifier) && floor) {
    if (tool_ == Tool::measure) {
      drag_ = Drag::measure;
      tape_ = {pressed_at_, pressed_at_};
    } else if (const auto handle = handle_at(pressed_)) {
      drag_ = *handle == Tool::move   ? Drag::move
              : *handle == Tool::turn ? Drag::turn
                                      : Drag::resize;
      ghost_ = {};
    }
  }
  update();
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  if (const auto floor = camera_.on_plane(at, size())) {
    Q_EMIT pointed_at(floor->x, floor->y);
  }
  if (drag_ == Drag::none) {
    if (tool_ != Tool::measure) {
      setCursor(handle_at(at) ? Qt::SizeAllCursor : Qt::ArrowCursor);
    }
    return;
  }
  if (drag_ == Drag::pressed && QLineF(at, pressed_).length() >= kClick) {
    const bool pans = button_ == Qt::RightButton || button_ == Qt::MiddleButton;
    drag_ = pans ? Drag::pan : Drag::orbit;
    if (pans) {
      followed_.clear();
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
  const auto floor = camera_.on_plane(pixel, size());
  const auto frame = frame_of_selected();
  if (!floor) {
    return;
  }
  const bool snaps = modifiers & Qt::ControlModifier;
  const double part = modifiers & Qt::ShiftModifier ? kFine : 1.0;
  const auto snapped = [&](double value, double step) {
    return snaps ? std::round(value / step) * step : value;
  };
  if (drag_ == Drag::measure) {
    tape_->second = {snapped(floor->x, kSnap), snapped(floor->y, kSnap), 0.0};
  } else if (frame && drag_ == Drag::move) {
    const Vector3 foot = frame->origin;
    ghost_.x = snapped(foot.x + part * (floor->x - pressed_at_.x), kSnap) - foot.x;
    ghost_.y = snapped(foot.y + part * (floor->y - pressed_at_.y), kSnap) - foot.y;
  } else if (frame && drag_ == Drag::turn) {
    const double heading = heading_of(*frame);
    const double wanted = std::atan2(floor->y - frame->origin.y, floor->x - frame->origin.x);
    const double by = part * wrap_angle(wanted - heading);
    ghost_.turn = radians(snapped(degrees(heading + by), kSnapTurn)) - heading;
  } else if (frame && drag_ == Drag::resize) {
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
  if (drag_ != Drag::pressed) {
    end_drag();
    return;
  }
  drag_ = Drag::none;
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
      Q_EMIT edit_wished(path, event->globalPosition().toPoint());
    } else {
      const Vector3 at = camera_.on_plane(event->position(), size()).value_or(Vector3{});
      Q_EMIT menu_wished(event->globalPosition().toPoint(), at.x, at.y);
    }
  }
}

void SceneView::end_drag() {
  const Drag drag = drag_;
  drag_ = Drag::none;
  if (drag == Drag::move && (ghost_.x != 0.0 || ghost_.y != 0.0)) {
    Q_EMIT moved(selection_, ghost_.x, ghost_.y);
  } else if (drag == Drag::turn && ghost_.turn != 0.0) {
    Q_EMIT turned(selection_.front(), ghost_.turn);
  } else if (drag == Drag::resize && ghost_.size) {
    Q_EMIT resized(selection_.front(), ghost_.size->x, ghost_.size->y);
  } else if (drag == Drag::measure) {
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

void SceneView::begin_typed(TypedDrag::Kind kind) {
  const auto frame = frame_of_selected();
  if (!frame || drag_ != Drag::none || locked_.contains(selection_.front()) ||
      (kind == TypedDrag::Kind::resize && !handle(Tool::resize))) {
    return;
  }
  typed_.begin(kind);
  ghost_ = {};
  drag_ = kind == TypedDrag::Kind::move   ? Drag::move
          : kind == TypedDrag::Kind::turn ? Drag::turn
                                          : Drag::resize;
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
  if (drag_ == Drag::move) {
    (axis == TypedDrag::Axis::y ? ghost_.y : ghost_.x) = number;
  } else if (drag_ == Drag::turn) {
    ghost_.turn = radians(number);
  } else if (const auto sides = size_of_selected(); sides && number > 0.0) {
    ghost_.size = Vector3{axis == TypedDrag::Axis::y ? sides->x : number * sides->x,
                          axis == TypedDrag::Axis::x ? sides->y : number * sides->y, 0.0};
  }
  update();
}

bool SceneView::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && typed_.is_on()) {
    event->accept();  // Enter and numbers are the view's now
    return true;
  }
  return QWidget::event(event);
}

void SceneView::keyPressEvent(QKeyEvent* event) {
  if (typed_.is_on() && event->key() != Qt::Key_Escape) {
    take_typed(*event);
    return;
  }
  const double step = event->modifiers() & Qt::ShiftModifier ? 0.01 : kSnap;
  const auto nudge = [&](double x, double y) {
    if (!selection_.isEmpty()) {
      Q_EMIT moved(selection_, x * step, y * step);
    }
  };
  switch (event->key()) {
    case Qt::Key_Escape:
      stop_drag();
      set_tool(Tool::move);
      break;
    case Qt::Key_7:
      look_from_top();
      break;
    case Qt::Key_1:
      look_from_front();
      break;
    case Qt::Key_3:
      look_from_side();
      break;
    case Qt::Key_Space:
      if (!event->isAutoRepeat()) {
        Q_EMIT run_wished();
      }
      break;
    case Qt::Key_G:
      begin_typed(TypedDrag::Kind::move);
      break;
    case Qt::Key_R:
      begin_typed(TypedDrag::Kind::turn);
      break;
    case Qt::Key_S:
      begin_typed(TypedDrag::Kind::resize);
      break;
    case Qt::Key_M:
      set_tool(Tool::measure);
      break;
    case Qt::Key_F:
      if (event->modifiers() & Qt::ShiftModifier) {
        follow(selection_.isEmpty() ? QString() : selection_.front());
      } else {
        frame_selection();
      }
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

#include "scene/scene_view.h"

#include <QLineF>
#include <QPainter>
#include <QResizeEvent>
#include <algorithm>
#include <cmath>

#include "paint/padlock.h"
#include "scene/drawing.h"
#include "scene/overlay_painter.h"

namespace elsie::desktop {
namespace {

constexpr double kHandle = 8.0;     // px, radius
constexpr double kReach = 11.0;     // px, from the middle of a handle
constexpr double kKnobAway = 30.0;  // px, from the edge of the thing

const QColor kSelected(0xe0, 0x80, 0x00);

}  // namespace

SceneView::SceneView(QWidget* parent) : QWidget(parent) {
  setObjectName("scene");
  setAccessibleName(tr("World"));
  setAccessibleDescription(
      tr("The world from the camera. All objects are also in the tree, with their places as "
         "numbers."));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(160, 120);
  setAttribute(Qt::WA_OpaquePaintEvent);
  connect(&refining_, &QTimer::timeout, this, &SceneView::refine);
  pacing_.setSingleShot(true);
  connect(&pacing_, &QTimer::timeout, this, qOverload<>(&QWidget::update));
}

SceneView::~SceneView() = default;

QString SceneView::device() const { return photograph_.device(); }

// The scene and its names

void SceneView::set_scene(const Json& scene, std::uint64_t epoch) {
  const double length = stage_.length(), width = stage_.width();
  stage_.set_scene(scene, epoch);
  if (!was_shown_ || length != stage_.length() || width != stage_.width()) {
    was_shown_ = !stage_.is_empty();
    show_all();
  }
  stop_drag();
  camera_moved();
}

void SceneView::set_notice(const QString& notice) {
  if (notice != notice_) {
    notice_ = notice;
    update();
  }
}

void SceneView::take(const snapshots::Snapshot& snapshot) {
  if (!stage_.take(snapshot)) {
    return;
  }
  if (stage_.has_changed()) {
    follow_robot();
    can_wait_ = can_wait_ || !is_stale_;
    is_stale_ = true;
  }
  update();
}

void SceneView::take_state(const Json& state) {
  const bool shows_fields = stage_.has_fields() && state.contains("fields");
  const bool shows_lights = stage_.has_actuators() && state.contains("lights");
  if (!shows_fields && !shows_lights) return;
  if (shows_fields) stage_.take_fields(state["fields"]);
  if (shows_lights) stage_.take_lights(state["lights"]);
  is_stale_ = true;
  update();
}

void SceneView::show_trails(const Past& past) {
  trails_.show(past);
  connect(&past, &Past::paths_changed, this, qOverload<>(&QWidget::update));
}

void SceneView::begin_trails_at(double time_s) {
  trails_.begin_at(time_s);
  update();
}

void SceneView::set_selection(const QStringList& paths) {
  if (paths != selection_) {
    selection_ = paths;
    // The mark of a sensor is in the photograph.
    is_stale_ =
        is_stale_ || stage_.sensor_frame(drawn_sensor_) || stage_.sensor_frame(selection_.value(0));
    stop_drag();
    update();
  }
}

void SceneView::toggle_locked(const QStringList& paths) {
  for (const QString& path : paths) {
    if (!locked_.remove(path)) locked_.insert(path);
  }
  update();
  Q_EMIT locks_changed();
}

void SceneView::unlock_all() {
  locked_.clear();
  update();
  Q_EMIT locks_changed();
}

std::vector<Label> SceneView::labels() const {
  return labels_of(stage_, camera_, size(), QFontMetricsF(font()));
}

void SceneView::rename(const QString& from, const QString& to) {
  if (followed_ == from) followed_ = to;
  if (locked_.remove(from)) {
    locked_.insert(to);
    Q_EMIT locks_changed();
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
  can_wait_ = false;
  trails_.paint_anew();
  update();
}

/// Whoever looks from elsewhere is no longer in a robot's place.
void SceneView::leave_seat() {
  if (camera_.seat) followed_.clear();
  camera_.seat.reset();
}

void SceneView::show_all() {
  leave_seat();
  // With the walls, and the numbers beyond them.
  const double around = 0.15 + 0.03 * std::max(stage_.length(), stage_.width());
  camera_.show(stage_.length() + around, stage_.width() + around, stage_.height(), size());
  all_ = camera_;
  camera_moved();
}

void SceneView::look(const OrbitCamera::View& from) {
  const bool shows_all = camera_ == all_;
  leave_seat();
  camera_.yaw = from.yaw;
  camera_.pitch = from.pitch;
  shows_all ? show_all() : camera_moved();
}

void SceneView::frame_selection() {
  leave_seat();
  if (const auto frame = frame_of_selected()) {
    camera_.target = {frame->origin.x, frame->origin.y, 0.0};
    camera_.distance = std::min(camera_.distance, std::max(0.6, 0.15 * stage_.length()));
    camera_moved();
  } else {
    show_all();
  }
}

void SceneView::follow(const QString& path, Follow how) {
  followed_ = path;
  follows_ = how;
  camera_.seat.reset();
  if (const Stage::Body* body = path.isEmpty() ? nullptr : stage_.body_of(path)) {
    constexpr double kBehind = 1.6, kOblique = -0.45;  // m, rad
    if (how == Follow::behind) {
      camera_.distance = kBehind;
      camera_.pitch = kOblique;
      camera_.yaw = heading_rad(body->frame);
    }
    follow_robot();
  }
  camera_moved();
}

void SceneView::follow_robot() {
  const Stage::Body* body = followed_.isEmpty() ? nullptr : stage_.body_of(followed_);
  if (!body) return;
  camera_.target = {body->frame.origin.x, body->frame.origin.y, 0.0};
  if (follows_ == Follow::behind) {
    constexpr double kPart = 0.15;  // of a turn that the camera makes with each picture
    camera_.yaw += kPart * wrap_angle(heading_rad(body->frame) - camera_.yaw);
  } else if (follows_ == Follow::eye) {
    camera_.seat = stage_.seat_of(followed_);
  }
  trails_.paint_anew();
}

// Painting

/// Once, before there is anything to see.
void SceneView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  QTimer::singleShot(0, this, [this] { photograph_.warm_up(); });
}

void SceneView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (!event->oldSize().isValid() || camera_ == all_) {  // the user has not moved it since
    show_all();
  }
  is_stale_ = true;
}

bool SceneView::is_dark() const { return palette().color(QPalette::Window).lightness() < 128; }

void SceneView::compose(double ratio) {
  is_stale_ = can_wait_ = false;
  drawn_ago_.start();
  drawn_overlays_ = overlays_;
  drawn_camera_ = camera_;
  drawn_ratio_ = ratio;
  drawn_sensor_ = selection_.value(0);
  refining_.stop();
  if (!photograph_.is_possible()) return;
  const int width = std::max(1, static_cast<int>(this->width() * ratio));
  const int height = std::max(1, static_cast<int>(this->height() * ratio));
  render::Scene scene = stage_.drawn();
  render::Style style;
  style.arena = {stage_.length(), stage_.width()};
  if (is_dark()) {
    style.outside = {42, 45, 50};
    style.horizon = {52, 56, 62};
    style.zenith = {24, 27, 32};
    if (!stage_.has_own_floor()) scene.floor = {172, 176, 180};
  }
  if (overlays_.grid) scene.drawing = grid_lines(stage_, camera_);
  const auto append = [](std::vector<render::Stroke>& to, const std::vector<render::Stroke>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  append(scene.drawing, goal_lines(stage_));
  if (overlays_.sketches) scene.strokes = sketch_lines(stage_);
  if (const auto sensor = stage_.sensor_frame(drawn_sensor_)) {
    append(scene.strokes, sensor_lines(*sensor));
  }
  for (auto* strokes : {&scene.drawing, &scene.strokes}) {
    for (render::Stroke& each : *strokes) each.width *= ratio, each.dash *= ratio;
  }
  photograph_.begin(std::move(scene),
                    {camera_.frame(),
                     {width, height, camera_.fov()},
                     camera_.seat ? stage_.carrier_of(followed_) : render::kNobody},
                    style);
  constexpr int kStill_ms = 200;  // without a movement
  if (isVisible()) refining_.start(kStill_ms);
}

/// Between two passes, the window takes its events.
void SceneView::refine() {
  if (!updatesEnabled()) {  // a film is written
    refining_.stop();
    return;
  }
  photograph_.refine();
  const int passes = photograph_.refined();
  if (photograph_.is_finished() || !photograph_.is_possible()) {
    refining_.stop();
  } else {
    refining_.setInterval(0);
  }
  // Each time that the picture has become twice as fine, and at the end, which may come early.
  if (passes >= 4 && ((passes & (passes - 1)) == 0 || photograph_.is_finished())) {
    photograph_.develop();
    update();
  }
}

void SceneView::paintEvent(QPaintEvent*) {
  // More than 40 pictures a second of a run would only slow it down.
  constexpr qint64 kApart_ms = 25;
  const qint64 wait_ms = can_wait_ ? kApart_ms - drawn_ago_.elapsed() : 0;
  const double ratio = devicePixelRatioF();
  if (drawn_overlays_ != overlays_ || drawn_ratio_ != ratio || (is_stale_ && wait_ms <= 0)) {
    compose(ratio);
    photograph_.take();
  } else if (is_stale_ && !pacing_.isActive()) {
    pacing_.start(static_cast<int>(wait_ms));
  }
  QPainter painter(this);
  paint(painter, true);
}

QImage SceneView::picture(int passes, double ratio) {
  if (ratio <= 0.0) ratio = devicePixelRatioF();
  compose(ratio);
  while (photograph_.is_possible() && photograph_.refined() < passes) photograph_.refine();
  return painted(ratio);
}

QImage SceneView::film_picture(double ratio) {
  if (!is_drawn(ratio)) compose(ratio);
  while (photograph_.is_possible() && photograph_.refined() < kFilm) {
    photograph_.refine(render::Shadows::sun);
  }
  return painted(ratio);
}

/// Whether the photograph shows what the view does.
bool SceneView::is_drawn(double ratio) const {
  return !is_stale_ && drawn_camera_ == camera_ && drawn_overlays_ == overlays_ &&
         drawn_ratio_ == ratio;
}

QImage SceneView::painted(double ratio) {
  if (photograph_.is_possible()) photograph_.develop();
  QImage image((QSizeF(size()) * ratio).toSize(), QImage::Format_RGB32);
  image.setDevicePixelRatio(ratio);
  QPainter painter(&image);
  paint(painter, false);
  return image;
}

void SceneView::paint(QPainter& painter, bool with_handles) {
  if (stage_.is_empty() && !notice_.isEmpty()) {
    painter.fillRect(rect(), palette().color(QPalette::Base));
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, notice_);
    return;
  }
  const double ratio = painter.device()->devicePixelRatioF();
  const QImage trails = overlays_.trails ? trails_.paint(stage_, camera_, size(), ratio) : QImage();
  const bool is_drawn = photograph_.is_possible() && !photograph_.image().isNull();
  if (is_drawn) {
    if (!trails.isNull()) lay_on_floor(photograph_.image(), trails, with_trails_);
    const QImage& drawn = trails.isNull() ? photograph_.image() : with_trails_;
    painter.drawImage(QRectF(QPointF(0.0, 0.0), QSizeF(drawn.size()) / ratio), drawn);
  } else {
    painter.fillRect(rect(), QColor(226, 228, 224));
  }
  painter.setRenderHint(QPainter::Antialiasing);
  if (stage_.is_empty()) return;
  const OverlayPainter over(painter, stage_, camera_, size(),
                            is_dark() ? QColor(190, 195, 200) : QColor(80, 86, 94));
  if (!is_drawn) {
    over.outlines();
    if (overlays_.grid) over.strokes(grid_lines(stage_, camera_));
    over.strokes(goal_lines(stage_));
    if (!trails.isNull()) painter.drawImage(QPoint(0, 0), trails);
    if (overlays_.sketches) over.strokes(sketch_lines(stage_));
  }
  const QString note = with_handles ? note_text() : QString();
  const QPointF note_at(8.0, height() - QFontMetricsF(font()).height());
  if (overlays_.grid && !camera_.seat) {
    over.scale(note.isEmpty() ? QRectF() : label_box(QFontMetricsF(font()), note_at, note));
  }
  over.rings();
  if (overlays_.sketches) over.sketches();
  if (overlays_.names) over.names();
  if (with_handles) {
    paint_locks(painter);
    paint_selection(painter, over);
    paint_tape(painter, over);
    if (!note.isEmpty()) over.note(note_at, note);
  }
}

/// What the lower edge says; "" if that is nothing.
QString SceneView::note_text() const {
  if (typed_.is_on()) return tr("%1   (Enter: apply, Esc: cancel)").arg(typed_.text());
  if (stage_.is_past()) {
    return tr("Looking back at %1 s: places only; sketches, fields and lights are not stored")
        .arg(stage_.time_s(), 0, 'f', 2);
  }
  if (overlays_.sketches && stage_.left_out() > 0) {
    return tr("%1 parts of sketches are not drawn: there are too many")
        .arg(qulonglong(stage_.left_out()));
  }
  return {};
}

// Selection and handles

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

#include "scene/scene_view.h"

#include <QPainter>
#include <QResizeEvent>
#include <algorithm>
#include <cmath>

#include "scene/drawing.h"
#include "scene/overlay_painter.h"

namespace elsie::desktop {

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
  if (!(camera_ == all_)) keep_in_view();
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
  constexpr double kPart = 0.15;  // of a turn that the camera makes with each picture
  if (follows_ == Follow::behind) {
    camera_.yaw += kPart * wrap_angle(heading_rad(body->frame) - camera_.yaw);
  } else if (follows_ == Follow::eye) {
    camera_.seat = stage_.seat_of(followed_);
  }
  keep_in_view((1.0 - kPart) * camera_.raised);
  trails_.paint_anew();
}

/// Raises the camera, at least so far, until it sees the robot that it follows over walls and
/// obstacles. What is high and far away hides the robot again and again while it drives, so that
/// the camera rises at once, and sinks bit by bit.
void SceneView::keep_in_view(double least_rad) {
  const Stage::Body* body = followed_.isEmpty() ? nullptr : stage_.body_of(followed_);
  const Stage::Solid* chassis = body ? stage_.chassis_of(*body) : nullptr;
  if (!chassis || camera_.seat) {
    camera_.stay_raised();
    return;
  }
  constexpr double kStep_rad = 0.02, kFoot = 0.4;  // of the chassis' height, below its middle
  const Vector3 foot = stage_.frame_of(*chassis).point({0.0, 0.0, -kFoot * chassis->shape.size.z});
  camera_.raised = least_rad;
  while (camera_.can_rise() && stage_.is_hidden(foot, camera_.frame().origin)) {
    camera_.raised += kStep_rad;
  }
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

}  // namespace elsie::desktop

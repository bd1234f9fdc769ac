// The main view: the world in three dimensions, in real time. scene_view_input.cpp handles the
// mouse and keys; scene_view_selection.cpp draws what is selected.
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QSet>
#include <QStringList>
#include <QTimer>
#include <QWidget>
#include <optional>

#include "scene/camera.h"
#include "scene/labels.h"
#include "scene/photograph.h"
#include "scene/stage.h"
#include "scene/trails.h"
#include "scene/typed_drag.h"

namespace elsie::desktop {

class OverlayPainter;

/// Draws the world off screen, where Mesa's software renderer is faster than in a window, and draws
/// handles and words over it.
///
/// The left button orbits, the right one pans, the wheel zooms to the pointer. A click selects,
/// with Shift several objects; a right click opens the editor. A selected object is moved by a drag
/// of it, or of its foot where it is small; the knob ahead turns it, the corner resizes a box,
/// unless it is too near on the screen to what moves or turns it. If Ctrl is down at the press, a
/// button always moves the camera; Ctrl during a drag snaps. G, R and S begin a drag by keys:
/// typed_drag.h.
class SceneView : public QWidget {
  Q_OBJECT

 public:
  using Tool = elsie::desktop::Tool;
  /// What is drawn over the solids.
  struct Overlays {
    bool trails = true;
    bool sketches = true;  // of plugins
    bool names = true;
    bool grid = true;

    friend bool operator==(const Overlays&, const Overlays&) = default;
  };
  /// How the camera goes with a robot.
  enum class Follow { above, behind, eye };

  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;

  void set_scene(const Json& scene, std::uint64_t epoch);
  /// What is said in the middle while there is no world.
  void set_notice(const QString& notice);
  const QString& notice() const { return notice_; }
  void take(const snapshots::Snapshot& snapshot);
  /// Takes an event `state`, for the fields of the world.
  void take_state(const Json& state);
  /// Where the lines behind the robots come from; it must outlive the view.
  void show_trails(const Past& past);
  /// Leaves out the lines from before this time, s.
  void begin_trails_at(double time_s);
  const Trails& trails() const { return trails_; }
  void set_selection(const QStringList& paths);
  /// Locks these objects, and unlocks those of them that were locked. Mouse and keys do not move
  /// locked objects.
  void toggle_locked(const QStringList& paths);
  void unlock_all();
  const QSet<QString>& locked() const { return locked_; }
  /// An object was renamed.
  void rename(const QString& from, const QString& to);

  const Stage& stage() const { return stage_; }
  OrbitCamera& camera() { return camera_; }
  Overlays& overlays() { return overlays_; }
  void set_tool(Tool tool);
  Tool tool() const { return tool_; }

  void show_all();
  void look(const OrbitCamera::View& from);
  void frame_selection();
  /// The camera follows this robot; "" stops following.
  void follow(const QString& path, Follow how = Follow::above);
  QString followed() const { return followed_; }
  Follow follows() const { return follows_; }

  /// The number of passes of a picture that is kept, and of a film's.
  static constexpr int kPicture = 2 * render::kFinished, kFilm = 4;
  /// A picture of the view without handles, of as many passes, with so many pixels for each of the
  /// widget's; 0: as on the screen.
  QImage picture(int passes = kPicture, double ratio = 0.0);
  /// The same for a film: drawn in a fraction of the time, or not at all if nothing has moved.
  QImage film_picture(double ratio);
  /// What is seen of the world without lines and words.
  const Photograph& photograph() const { return photograph_; }
  Photograph& photograph() { return photograph_; }
  /// The names that are drawn: as many as there is room for, those nearest to the camera first.
  std::vector<Label> labels() const;
  /// The OpenGL renderer, such as "llvmpipe ..."; "" if Qt draws outlines, without OpenGL.
  QString device() const;
  /// The pixel of a point of the world in the widget, for tests and tutorials.
  std::optional<QPointF> pixel_of(const Vector3& point) const {
    return camera_.project(point, size());
  }
  /// The middle of a tool's handle on the selected object; none if it has none, or no room for it.
  std::optional<QPointF> handle(Tool tool) const;

 Q_SIGNALS:
  void selected(const QStringList& paths);
  void said(const QString& sentence);
  void locks_changed();
  void edit_wished(const QString& path);
  /// `floor`: the point of the floor there, m.
  void menu_wished(const QPoint& global, std::optional<QPointF> floor);
  /// The menu key was pressed: opens the menu of the selected object.
  void element_menu_wished(const QString& path, const QPoint& global);
  /// A drag has ended; the movement is in m or rad.
  void moved(const QStringList& paths, double by_x, double by_y);
  void turned(const QString& path, double by_rad);
  void resized(const QString& path, double length, double width);
  void measured(double from_x, double from_y, double to_x, double to_y);
  void run_wished();

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  QSize sizeHint() const override { return {640, 480}; }

 private:
  enum class Drag { none, pressed, orbit, pan, tool };
  struct Ghost {
    double x = 0.0, y = 0.0, turn = 0.0;
    std::optional<Vector3> size;
  };

  void compose(double ratio);
  bool is_drawn(double ratio) const;
  QImage painted(double ratio);
  void refine();
  void follow_robot();
  void keep_in_view(double least_rad = 0.0);
  void leave_seat();
  bool is_dark() const;
  void paint(QPainter& painter, bool with_handles);
  void paint_selection(QPainter& painter, const OverlayPainter& over) const;
  void paint_coverage(QPainter& painter, const OverlayPainter& over, const Stage::Body& body) const;
  QString note_text() const;
  void paint_locks(QPainter& painter) const;
  void paint_ghost(QPainter& painter, const OverlayPainter& over, const Stage::Solid& solid) const;
  void paint_tape(QPainter& painter, const OverlayPainter& over) const;
  void camera_moved();
  QStringList movable() const;
  std::optional<QPointF> place_of_handle(Tool tool) const;
  /// What a drag from there does with the selection. `height`: receives that of what is held, m.
  std::optional<Tool> handle_at(const QPointF& pixel, double* height = nullptr) const;
  void paint_handles(QPainter& painter) const;
  std::optional<Frame> frame_of_selected() const;
  std::optional<Vector3> size_of_selected() const;
  bool is_selection_dragged() const { return drag_ == Drag::tool && dragged_ != Tool::measure; }
  void drag_to(const QPointF& pixel, Qt::KeyboardModifiers modifiers);
  void begin_typed(Tool tool);
  void take_typed(const QKeyEvent& key);
  void end_drag();
  void stop_drag();

  Stage stage_;
  OrbitCamera camera_;
  OrbitCamera all_;  // as show_all() left it
  Overlays overlays_;
  Photograph photograph_;
  QImage with_trails_;  // the photograph and the trails
  QTimer refining_;     // while nothing moves
  QTimer pacing_;       // until the next picture of what robots do
  QElapsedTimer drawn_ago_;
  bool is_stale_ = true;
  bool can_wait_ = false;    // what is stale is not what a hand did
  Overlays drawn_overlays_;  // of the photograph, as what follows
  OrbitCamera drawn_camera_;
  double drawn_ratio_ = 0.0;
  QString drawn_sensor_;
  bool was_shown_ = false;
  Trails trails_;
  QStringList selection_;
  QSet<QString> locked_;
  QString followed_;
  Follow follows_ = Follow::above;
  QString notice_;
  Tool tool_ = Tool::move;

  Drag drag_ = Drag::none;
  Tool dragged_ = Tool::none;  // while drag_ is Drag::tool
  Qt::MouseButton button_ = Qt::NoButton;
  QPointF pressed_, last_;
  Vector3 pressed_at_;
  double held_height_ = 0.0;  // m
  Ghost ghost_;
  TypedDrag typed_;
  std::optional<std::pair<Vector3, Vector3>> tape_;
};

}  // namespace elsie::desktop

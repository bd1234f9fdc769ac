// Start, pause, step, reset, speed and seed; and the time line of the run.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <algorithm>
#include <utility>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QSlider;
class QToolButton;

namespace elsie::desktop {

class Workbench;

/// Eight speeds from a tenth of real time to ten times it, and as fast as it goes.
class ControlBar : public QWidget {
  Q_OBJECT

 public:
  explicit ControlBar(Workbench& workbench, QWidget* parent = nullptr);

  /// What Start does with the past that is shown.
  enum class Past { none, may_play, plays };
  void show_past(Past past);
  /// The one of the run, instead of what was typed.
  void show_seed();

 Q_SIGNALS:
  void run_wished();  // or a pause
  void seed_wished(quint64 seed);

 private:
  void show_state();

  Workbench& workbench_;
  Past past_ = Past::none;
  QToolButton* run_;
  QToolButton* step_;
  QToolButton* reset_;
  QComboBox* speed_;
  QLineEdit* seed_;
};

/// From the start of the run to now. Moving the slider pauses the run and shows the past; the run
/// goes on from where it was. Keys: arrows go by a tenth of a second, with Shift by a second; comma
/// and full stop to the event before and after; Home and End to the start and to now.
class TimeLine : public QWidget {
  Q_OBJECT

 public:
  explicit TimeLine(Workbench& workbench, QWidget* parent = nullptr);

  /// Marks an event of the run.
  void mark(double time_s, const QString& what);
  void clear();
  /// What a recording has of this run, which lasts until `until_s`: marked ahead of the run. 0
  /// takes it away.
  using Marks = std::vector<std::pair<double, QString>>;
  void expect(Marks events, double until_s);
  bool is_in_the_past() const { return is_in_the_past_; }
  /// Shows the past, or lets the run go on to that time.
  void go_to(double time_s);
  void go_to_now();
  /// Shows what was, from the shown time on, at the speed of the run; has_caught_up() when it comes
  /// to now.
  void play();
  void stop_playing();
  bool is_playing() const { return play_timer_.isActive(); }
  /// The next or last event from the shown time.
  void go_to_event(bool next);
  void move_by(double by_s);
  /// What happened at about that time, one line an event; "": nothing.
  QString tip_at(double time_s) const;
  /// The events of the run, and those ahead of it, as they come.
  Marks events() const;

 Q_SIGNALS:
  void past_changed();  // is_in_the_past() or is_playing()
  void has_caught_up();

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void show_now();
  double time_at(double x) const;  // s; `x` in the widget
  double span_s() const { return std::max(until_s_, ahead_until_s_); }
  void show_past(double time_s);
  void play_on();

  Workbench& workbench_;
  QSlider* slider_;
  QLabel* label_;
  QToolButton* now_;
  double until_s_ = 0.0;
  double shown_s_ = 0.0;
  double asked_s_ = 0.0;  // the past that was last asked for
  bool is_in_the_past_ = false;
  bool was_in_the_past_ = false;  // when it was said last
  bool is_showing_ = false;
  bool is_pressed_ = false;  // the slider, also before it takes hold of its handle
  QTimer play_timer_;
  QElapsedTimer since_played_;
  Marks marks_, ahead_;
  double ahead_until_s_ = 0.0;
};

}  // namespace elsie::desktop

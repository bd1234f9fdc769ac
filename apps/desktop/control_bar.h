// Start, pause, step, reset, speed and seed; and the time line of the run.
#pragma once

#include <QElapsedTimer>
#include <QStringList>
#include <QTimer>
#include <QWidget>
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "engine/past.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QSlider;
class QToolButton;

namespace elsie::desktop {

class Workbench;

/// The buttons of a run, its speed and its seed. The speeds are seven from a tenth of real time to
/// ten times real time, and as fast as possible.
class ControlBar : public QWidget {
  Q_OBJECT

 public:
  explicit ControlBar(Workbench& workbench, QWidget* parent = nullptr);

  /// What Start does while the past is shown.
  enum class Past { none, may_play, plays };
  void show_past(Past past);
  /// Shows the seed of the run instead of what was typed.
  void show_seed();

 Q_SIGNALS:
  void run_wished();  // run or pause requested
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

/// The time from the start of the run to now. Moving the slider pauses the run and shows the past;
/// the run later continues from where it was. Keys: Left and Right move by 0.1 s, with Shift by 1
/// s; comma and period go to the previous and next event; Home and End go to the start and to now.
class TimeLine : public QWidget {
  Q_OBJECT

 public:
  explicit TimeLine(Workbench& workbench, QWidget* parent = nullptr);

  /// Marks an event of the run.
  void mark(double time_s, const QString& what);
  void clear();
  /// Marks the events of a recording of this run ahead of the present. The recording lasts until
  /// `until_s`, in s. No events and 0 remove the marks.
  using Marks = std::vector<std::pair<double, QString>>;
  void expect(Marks events, double until_s);
  bool is_in_the_past() const { return is_in_the_past_; }
  /// The robots whose stored numbers instant() has.
  void set_robots(const QStringList& robots);
  /// What is stored of the shown time; null while the present is shown, and before it has come.
  const Instant* instant() const { return instant_ ? &*instant_ : nullptr; }
  /// Shows that time of the past, or runs on to that time.
  void go_to(double time_s);
  void go_to_now();
  /// Plays the past from the shown time at the speed of the run; emits has_caught_up() when it
  /// reaches the present.
  void play();
  void stop_playing();
  bool is_playing() const { return play_timer_.isActive(); }
  /// Goes to the next or the previous event, seen from the shown time.
  void go_to_event(bool next);
  void move_by(double by_s);
  /// The events at about that time, one per line; "" if there are none.
  QString tip_at(double time_s) const;
  /// The events of the run, and those of the recording ahead of it, in order of time.
  Marks events() const;

 Q_SIGNALS:
  void past_changed();  // is_in_the_past() or is_playing() has changed
  void instant_changed();
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
  void ask_for(double time_s);
  void take(const Json& answer);
  void play_on();

  Workbench& workbench_;
  QStringList robots_;
  std::optional<Instant> instant_;
  QSlider* slider_;
  QLabel* label_;
  QToolButton* now_;
  double until_s_ = 0.0;
  double shown_s_ = 0.0;
  double asked_s_ = 0.0;  // the time of the past that was asked for last
  bool is_in_the_past_ = false;
  bool was_in_the_past_ = false;  // when past_changed() was last considered
  bool is_pressed_ = false;  // the mouse button is down on the slider, even before the slider takes
                             // hold of its handle
  QTimer play_timer_;
  QElapsedTimer since_played_;
  Marks marks_, ahead_;
  double ahead_until_s_ = 0.0;
};

}  // namespace elsie::desktop

// Start, pause, step, reset, speed and seed; and the time line of the run.
#pragma once

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

 private:
  void show_state();

  Workbench& workbench_;
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
  /// What a recording has of this run, which lasts until `until_s`: marked ahead of the run. An
  /// empty list takes it away.
  using Marks = std::vector<std::pair<double, QString>>;
  void expect(Marks events, double until_s);
  bool is_in_the_past() const { return is_in_the_past_; }
  /// Shows the past, or lets the run go on to that time.
  void go_to(double time_s);
  void go_to_now();
  /// The next or last event from the shown time.
  void go_to_event(bool next);
  void move_by(double by_s);
  /// What happened at about that time, one line an event; "": nothing.
  QString tip_at(double time_s) const;

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void show_now();
  double time_at(double x) const;  // s; `x` in the widget
  double span_s() const { return std::max(until_s_, ahead_until_s_); }
  /// The events of the run, and those ahead of it.
  Marks all_marks() const;

  Workbench& workbench_;
  QSlider* slider_;
  QLabel* label_;
  QToolButton* now_;
  double until_s_ = 0.0;
  double shown_s_ = 0.0;
  double asked_s_ = 0.0;  // the past that was last asked for
  bool is_in_the_past_ = false;
  bool is_showing_ = false;
  Marks marks_, ahead_;
  double ahead_until_s_ = 0.0;
};

}  // namespace elsie::desktop

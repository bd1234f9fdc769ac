// Start, pause, step, reset, speed and seed; and the time line of the run.
#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QSlider;
class QToolButton;

namespace elsie::desktop {

class Workbench;

/// Ten positions from a tenth of real time to ten times it, and as fast as it goes.
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
/// goes on from where it was.
class TimeLine : public QWidget {
  Q_OBJECT

 public:
  explicit TimeLine(Workbench& workbench, QWidget* parent = nullptr);

  /// Marks an event of the run.
  void mark(double time_s, const QString& what);
  void clear();
  bool is_in_the_past() const { return is_in_the_past_; }
  void go_to(double time_s);
  void go_to_now();
  /// The next or last event from the shown time.
  void go_to_event(bool next);
  void move_by(double by_s);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void show_now();

  Workbench& workbench_;
  QSlider* slider_;
  QLabel* label_;
  QToolButton* now_;
  double until_s_ = 0.0;
  double shown_s_ = 0.0;
  bool is_in_the_past_ = false;
  bool is_showing_ = false;
  std::vector<std::pair<double, QString>> marks_;
};

}  // namespace elsie::desktop

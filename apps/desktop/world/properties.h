// The attributes of the selected object as a form; every entry is an edit.
#pragma once

#include <QTimer>
#include <QWidget>
#include <array>

#include "engine/catalog.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;

namespace elsie::desktop {

class Form;
class Workbench;

class Properties : public QWidget {
  Q_OBJECT

 public:
  explicit Properties(Workbench& workbench, QWidget* parent = nullptr);

  /// Shows the element at the path; "" is the world.
  void show_element(const QString& path);
  /// Shows the members of the list ("sensors") of the element at `holder`, and a button that adds
  /// to it.
  void show_list(const QString& holder, const QString& list);
  /// The shown object was renamed.
  void rename(const QString& from, const QString& to);
  /// Shows values of the selected object at the shown time, from a `state` event or
  /// Instant::state_of(): for a behaviour the weight that its coordinator gives it, for a robot its
  /// speed and energy.
  void show_state(const Json& state);
  /// Shows where the selected object is at the shown time, next to its place at the start; m and
  /// degrees.
  void show_pose(double x, double y, double heading_deg);
  const QString& path() const { return path_; }
  Form& form() { return *form_; }

 Q_SIGNALS:
  void add_wished(const QString& holder, const QString& list);

 private:
  void refresh();
  void refresh_list();
  void change(const QString& path, const QString& name, const QString& edit);
  void show_last_pose();
  void show_number(const QString& name, const QString& title, double value, int digits,
                   const QString& unit);
  void show_live(const QString& name, const QString& title, const QString& value);

  Workbench& workbench_;
  QString path_;
  QString list_;  // of the element at the path; "" shows the element itself
  QLabel* title_;
  QLabel* about_;
  std::array<double, 3> pose_{};
  QTimer pose_timer_;
  QLineEdit* filter_;
  Form* form_;
  QScrollArea* scroll_;
  QPushButton* add_;
};

/// The element at a path, or a part that every world has and that its file does not name.
struct Described {
  QString title;
  Kind kind;
  Json values;
};
std::optional<Described> described_at(const Workbench& workbench, const QString& path);

}  // namespace elsie::desktop

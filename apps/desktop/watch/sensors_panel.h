// All sensors of a robot with their present readings.
#pragma once

#include <QWidget>

#include "engine/json.h"

class QLineEdit;
class QTreeWidget;

namespace elsie::desktop {

class SensorsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SensorsPanel(QWidget* parent = nullptr);

  void set_robot(const QString& id);
  /// Takes a `state` event.
  void add(const Json& state);
  void clear();

 private:
  void filter();

  QString robot_;
  QLineEdit* filter_;
  QTreeWidget* table_;
};

}  // namespace elsie::desktop

// All sensors of a robot with their readings, now or at the shown time of the past. A long array is
// a strip of bars.
#pragma once

#include <QPixmap>
#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

#include "engine/past.h"

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
  /// Shows the readings of that time; null: those of the present.
  void look_back(const Instant* then);
  void clear();

 private:
  struct Row {
    QString name;
    QString text;
    std::vector<double> strip;  // a long array; else empty
  };
  void show_all();
  /// A field of a sensor with the values of the shown time.
  Json shown(const Json& field, const QString& sensor) const;
  int show_heard(int row, bool& is_new);
  /// An array of a few numbers has a row for each.
  std::vector<Row> rows_of(const Json& field) const;
  /// Fills a row. Returns whether its names have changed.
  bool show(int row, const QStringList& of, const Row& what);
  QPixmap strip_of(const std::vector<double>& values) const;
  void filter();

  QString robot_;
  Json present_;  // the robot of the last state
  std::optional<Instant> then_;
  QLineEdit* filter_;
  QTreeWidget* table_;
};

}  // namespace elsie::desktop

// All sensors of a robot with their present readings. A long array is a strip of bars.
#pragma once

#include <QPixmap>
#include <QStringList>
#include <QWidget>
#include <vector>

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
  struct Row {
    QString name;
    QString text;
    std::vector<double> strip;  // a long array; else empty
  };
  /// An array of a few numbers has a row for each.
  std::vector<Row> rows_of(const Json& field) const;
  /// Fills a row. Returns whether its names have changed.
  bool show(int row, const QStringList& of, const Row& what);
  QPixmap strip_of(const std::vector<double>& values) const;
  void filter();

  QString robot_;
  QLineEdit* filter_;
  QTreeWidget* table_;
};

}  // namespace elsie::desktop

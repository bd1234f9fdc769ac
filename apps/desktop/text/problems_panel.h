// The list of problems of the open files.
#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

#include "engine/problem.h"

class QTreeWidget;
class QTreeWidgetItem;

namespace elsie::desktop {

class ProblemsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ProblemsPanel(QWidget* parent = nullptr);

  void set_problems(const std::vector<Problem>& problems);
  /// Selects the next problem, after the last one the first, and goes to it.
  void next();

 Q_SIGNALS:
  void go_to(const QString& file, int line);

 private:
  void add_lines(QTreeWidgetItem& problem, const QStringList& lines);
  void go(const QTreeWidgetItem* item);

  QTreeWidget* list_;
};

}  // namespace elsie::desktop

#include "text/problems_panel.h"

#include <QFileInfo>
#include <QHeaderView>
#include <QShortcut>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace elsie::desktop {

ProblemsPanel::ProblemsPanel(QWidget* parent) : QWidget(parent), list_(new QTreeWidget(this)) {
  list_->setObjectName(QStringLiteral("problems"));
  list_->setAccessibleName(tr("Problems"));
  list_->setToolTip(tr("Enter or a double click goes to the line; F8 goes to the next problem"));
  list_->setHeaderLabels({tr("Problem"), tr("Line"), tr("File")});
  list_->setRootIsDecorated(false);
  list_->setAlternatingRowColors(true);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(list_);
  // itemActivated comes with Enter and, on most desktops, with a double click; here a double click
  // always works.
  connect(list_, &QTreeWidget::itemDoubleClicked, this, &ProblemsPanel::go);
  for (const auto key : {Qt::Key_Return, Qt::Key_Enter}) {
    auto* enter = new QShortcut(key, list_);
    enter->setContext(Qt::WidgetShortcut);
    connect(enter, &QShortcut::activated, this, [this] { go(list_->currentItem()); });
  }
  auto* f8 = new QShortcut(Qt::Key_F8, this);
  f8->setContext(Qt::WidgetWithChildrenShortcut);
  connect(f8, &QShortcut::activated, this, &ProblemsPanel::next);
}

void ProblemsPanel::set_problems(const std::vector<Problem>& problems) {
  list_->clear();
  for (const Problem& problem : problems) {
    auto* item = new QTreeWidgetItem(
        list_, {problem.is_warning ? tr("Warning: %1").arg(problem.message) : problem.message,
                problem.line > 0 ? QString::number(problem.line) : QString(),
                QFileInfo(problem.file).fileName()});
    item->setData(0, Qt::UserRole, problem.file);
    item->setData(1, Qt::UserRole, problem.line);
    item->setToolTip(0, problem.message);
    item->setToolTip(2, problem.file);
  }
}

void ProblemsPanel::next() {
  if (const int count = list_->topLevelItemCount(); count > 0) {
    const int now = list_->indexOfTopLevelItem(list_->currentItem());
    list_->setCurrentItem(list_->topLevelItem((now + 1) % count));
    go(list_->currentItem());
  }
}

void ProblemsPanel::go(const QTreeWidgetItem* item) {
  if (item != nullptr) {
    Q_EMIT go_to(item->data(0, Qt::UserRole).toString(), item->data(1, Qt::UserRole).toInt());
  }
}

}  // namespace elsie::desktop

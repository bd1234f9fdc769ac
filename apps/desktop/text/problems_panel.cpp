#include "text/problems_panel.h"

#include <QFileInfo>
#include <QFontDatabase>
#include <QHeaderView>
#include <QShortcut>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "engine/compiler_messages.h"
#include "look/icons.h"

namespace elsie::desktop {
namespace {

void set_place(QTreeWidgetItem& item, const QString& file, int line) {
  item.setData(0, Qt::UserRole, file);
  item.setData(1, Qt::UserRole, line);
  item.setText(1, line > 0 ? QString::number(line) : QString());
  item.setText(2, QFileInfo(file).fileName());
  item.setToolTip(2, file);
}

}  // namespace

ProblemsPanel::ProblemsPanel(QWidget* parent) : QWidget(parent), list_(new QTreeWidget(this)) {
  list_->setObjectName(QStringLiteral("problems"));
  list_->setAccessibleName(tr("Problems"));
  list_->setToolTip(tr("Enter or a double click goes to the line; F8 goes to the next problem"));
  list_->setHeaderLabels({tr("Problem"), tr("Line"), tr("File")});
  list_->setFrameShape(QFrame::NoFrame);
  list_->setExpandsOnDoubleClick(false);
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
  bool has_lines = false;
  for (const Problem& problem : problems) {
    const QStringList lines = problem.message.split('\n', Qt::SkipEmptyParts);
    const QString first = lines.value(0);
    auto* item =
        new QTreeWidgetItem(list_, {problem.is_warning ? tr("Warning: %1").arg(first) : first});
    item->setIcon(0, icon(problem.is_warning ? "warning" : "error"));
    item->setToolTip(0, problem.message);
    set_place(*item, problem.file, problem.line);
    if (lines.size() > 1) {
      add_lines(*item, lines);
      has_lines = true;
    }
  }
  list_->setRootIsDecorated(has_lines);
}

/// The lines of a compiler after the first, below it, as it wrote them. The problem stands where
/// the first error does.
void ProblemsPanel::add_lines(QTreeWidgetItem& problem, const QStringList& lines) {
  const QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  CompilerLine last = compiler_line(lines.value(0)).value_or(CompilerLine());
  bool has_error = last.is_error;
  for (const QString& line : lines.mid(1)) {
    auto* item = new QTreeWidgetItem(&problem, {line});
    item->setFont(0, fixed);
    item->setToolTip(0, line);
    const auto located = compiler_line(line);
    if (located) last = *located;
    if (last.line > 0) {  // the lines after it show the place
      item->setData(0, Qt::UserRole, last.file);
      item->setData(1, Qt::UserRole, last.line);
    }
    if (located && located->is_error && !has_error) {
      has_error = true;
      problem.setText(0, problem.text(0) + ' ' + located->what);
      set_place(problem, located->file, located->line);
    }
  }
  problem.setExpanded(true);
}

void ProblemsPanel::next() {
  if (const int count = list_->topLevelItemCount(); count > 0) {
    const QTreeWidgetItem* now = list_->currentItem();
    while (now && now->parent()) now = now->parent();
    const int row = list_->indexOfTopLevelItem(const_cast<QTreeWidgetItem*>(now));
    list_->setCurrentItem(list_->topLevelItem((row + 1) % count));
    go(list_->currentItem());
  }
}

void ProblemsPanel::go(const QTreeWidgetItem* item) {
  if (item != nullptr) {
    Q_EMIT go_to(item->data(0, Qt::UserRole).toString(), item->data(1, Qt::UserRole).toInt());
  }
}

}  // namespace elsie::desktop

#include "paint/figures.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QAction>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace elsie::desktop {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("elsie::desktop", text); }

/// Has the name and the description of the widget, and its figures as the value.
class PaintedFigures : public QAccessibleWidget {
 public:
  explicit PaintedFigures(QWidget* widget) : QAccessibleWidget(widget, QAccessible::Chart) {}

  QString text(QAccessible::Text which) const override {
    const auto* shows = dynamic_cast<const ShowsFigures*>(widget());
    if (which != QAccessible::Value || !shows) {
      return QAccessibleWidget::text(which);
    }
    const Figures figures = shows->figures();
    QStringList lines;
    for (const QStringList& row : figures.rows) {
      QStringList cells;
      for (qsizetype i = 0; i < row.size(); ++i) {
        cells << (i < figures.columns.size() ? figures.columns[i] + ' ' : QString()) + row[i];
      }
      lines << cells.join(", ");
    }
    return lines.join('\n');
  }
};

QAccessibleInterface* make_interface(const QString&, QObject* object) {
  auto* widget = qobject_cast<QWidget*>(object);
  return widget && dynamic_cast<ShowsFigures*>(widget) ? new PaintedFigures(widget) : nullptr;
}

void fill(QTableWidget* table, const Figures& figures) {
  table->setColumnCount(static_cast<int>(figures.columns.size()));
  table->setRowCount(static_cast<int>(figures.rows.size()));
  table->setHorizontalHeaderLabels(figures.columns);
  for (int row = 0; row < table->rowCount(); ++row) {
    const QStringList& cells = figures.rows[static_cast<std::size_t>(row)];
    for (int column = 0; column < static_cast<int>(cells.size()); ++column) {
      table->setItem(row, column, new QTableWidgetItem(cells[column]));
    }
  }
  table->horizontalHeader()->setMaximumSectionSize(48 * table->fontMetrics().averageCharWidth());
  table->resizeColumnsToContents();
  table->resizeRowsToContents();
}

}  // namespace

void offer_figures(QWidget* widget) {
  static const bool is_installed = [] {
    QAccessible::installFactory(make_interface);
    return true;
  }();
  static_cast<void>(is_installed);
  auto* table = new QAction(tr("As a &table..."), widget);
  table->setObjectName("figures");
  QObject::connect(table, &QAction::triggered, widget, [widget] { show_figures(widget); });
  widget->addAction(table);
  if (widget->contextMenuPolicy() == Qt::DefaultContextMenu) {
    widget->setContextMenuPolicy(Qt::ActionsContextMenu);
  }
}

void show_figures(QWidget* widget) {
  const auto* shows = dynamic_cast<const ShowsFigures*>(widget);
  auto* dialog = new QDialog(widget);
  dialog->setObjectName("figures_dialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(widget->accessibleName());
  auto* table = new QTableWidget;
  table->setObjectName("figures_table");
  table->setAccessibleName(widget->accessibleName());
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  fill(table, shows->figures());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  buttons->setObjectName("buttons");
  QPushButton* again = buttons->addButton(tr("&Again"), QDialogButtonBox::ActionRole);
  again->setToolTip(tr("The figures of this instant"));
  QObject::connect(again, &QPushButton::clicked, table,
                   [table, shows] { fill(table, shows->figures()); });
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
  auto* column = new QVBoxLayout(dialog);
  column->addWidget(table);
  column->addWidget(buttons);
  dialog->resize(100 * widget->fontMetrics().averageCharWidth(),
                 26 * widget->fontMetrics().height());
  dialog->show();
}

}  // namespace elsie::desktop

#include "watch/sensors_panel.h"

#include <QHeaderView>
#include <QLineEdit>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "paint/axes.h"
#include "watch/state.h"

namespace elsie::desktop {

SensorsPanel::SensorsPanel(QWidget* parent)
    : QWidget(parent), filter_(new QLineEdit(this)), table_(new QTreeWidget(this)) {
  filter_->setObjectName(QStringLiteral("sensors_filter"));
  filter_->setPlaceholderText(tr("Filter"));
  filter_->setAccessibleName(tr("Filter of the sensors"));
  filter_->setClearButtonEnabled(true);
  setFocusProxy(filter_);
  table_->setObjectName(QStringLiteral("sensors_table"));
  table_->setAccessibleName(tr("Sensors and their readings"));
  table_->setToolTip(tr("Readings are in SI units: m, m/s, rad, rad/s"));
  table_->setHeaderLabels({tr("Sensor"), tr("Kind"), tr("Reading"), tr("Value")});
  table_->setRootIsDecorated(false);
  table_->header()->moveSection(1, 3);  // the column that is cut off first
  table_->header()->setStretchLastSection(true);
  table_->setAlternatingRowColors(true);
  table_->setUniformRowHeights(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(filter_);
  column->addWidget(table_);
  connect(filter_, &QLineEdit::textChanged, this, &SensorsPanel::filter);
}

void SensorsPanel::set_robot(const QString& id) {
  if (id != robot_) {
    robot_ = id;
    clear();
  }
}

void SensorsPanel::clear() { table_->clear(); }

void SensorsPanel::add(const Json& state) {
  const Json& robot = robot_of(state, robot_);
  if (robot.is_null() || !robot.contains("sensors")) {
    return;
  }
  int row = 0;
  bool is_new = false;
  for (const Json& sensor : member(robot, "sensors")) {
    const Json& names = member(sensor, "names");
    const Json& values = member(sensor, "values");
    for (std::size_t i = 0; i < values.size(); ++i, ++row) {
      auto* item = table_->topLevelItem(row);
      if (item == nullptr) {
        item = new QTreeWidgetItem(table_);
        item->setTextAlignment(3, Qt::AlignRight | Qt::AlignVCenter);
        is_new = true;
      }
      const QString name = i < names.size() && names[i].is_string()
                               ? QString::fromStdString(names[i].get<std::string>())
                               : QString::number(i + 1);
      const QStringList cells{
          text_of(sensor, "id"), text_of(sensor, "plugin"), name,
          values[i].is_number() ? number_text(values[i].get<double>()) : QStringLiteral("-")};
      for (int cell = 0; cell < cells.size(); ++cell) {
        if (item->text(cell) != cells[cell]) {
          item->setText(cell, cells[cell]);
          is_new = is_new || cell < 3;
        }
      }
    }
  }
  while (table_->topLevelItemCount() > row) {
    delete table_->topLevelItem(row);
  }
  if (is_new) {
    for (int cell = 0; cell < 4; ++cell) {
      table_->resizeColumnToContents(cell);
    }
    filter();
  }
}

void SensorsPanel::filter() {
  for (int row = 0; row < table_->topLevelItemCount(); ++row) {
    auto* item = table_->topLevelItem(row);
    const QString all = item->text(0) + u' ' + item->text(1) + u' ' + item->text(2);
    item->setHidden(!all.contains(filter_->text(), Qt::CaseInsensitive));
  }
}

}  // namespace elsie::desktop

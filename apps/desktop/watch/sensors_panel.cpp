#include "watch/sensors_panel.h"

#include <QHeaderView>
#include <QLineEdit>
#include <QPainter>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "paint/axes.h"
#include "watch/state.h"

namespace elsie::desktop {
namespace {

constexpr std::size_t kMostRows = 8;  // of an array; longer ones are strips
constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();

}  // namespace

SensorsPanel::SensorsPanel(QWidget* parent)
    : QWidget(parent), filter_(new QLineEdit(this)), table_(new QTreeWidget(this)) {
  filter_->setObjectName(QStringLiteral("sensors_filter"));
  filter_->setPlaceholderText(tr("Filter"));
  filter_->setAccessibleName(tr("Filter of the sensors"));
  filter_->setClearButtonEnabled(true);
  setFocusProxy(filter_);
  table_->setObjectName(QStringLiteral("sensors_table"));
  table_->setAccessibleName(tr("Sensors and their readings"));
  table_->setIconSize({96, fontMetrics().height()});
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

void SensorsPanel::clear() {
  present_ = Json();
  table_->clear();
}

void SensorsPanel::add(const Json& state) {
  const Json& robot = robot_of(state, robot_);
  if (!robot.is_null() && robot.contains("sensors")) {
    present_ = robot;
    show_all();
  }
}

void SensorsPanel::look_back(const Instant* then) {
  then_ = then ? std::optional(*then) : std::nullopt;
  show_all();
}

void SensorsPanel::show_all() {
  int row = 0;
  bool is_new = false;
  for (const Json& sensor : member(present_, "sensors")) {
    const QString id = text_of(sensor, "id");
    for (const Json& field : member(sensor, "fields")) {
      for (const Row& each : rows_of(then_ ? shown(field, id) : field)) {
        is_new |= show(row++, {id, text_of(sensor, "plugin"), each.name}, each);
      }
    }
  }
  row = show_heard(row, is_new);
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

Json SensorsPanel::shown(const Json& field, const QString& sensor) const {
  const QString name = robot_ + u'/' + sensor + u'/' + text_of(field, "name");
  Json values = Json::array();
  const auto add = [&](const QString& number) {
    const double value = then_->number(number);
    values.push_back(std::isfinite(value) ? Json(value) : Json());
  };
  const int size = integer_of(field, "size", 0);
  for (int i = 0; i < size; ++i) add(name + u'.' + QString::number(i));
  while (!values.empty() && values.back().is_null()) values.erase(values.size() - 1);
  if (!field.contains("size")) add(name);
  Json shown = field;
  shown["values"] = std::move(values);
  return shown;
}

/// Adds rows from this one on; returns the row after them.
int SensorsPanel::show_heard(int row, bool& is_new) {
  const Json& robot = then_ ? robot_of(then_->look, robot_) : present_;
  const Json& sensors = member(present_, "sensors");
  const bool may_hear = std::any_of(sensors.begin(), sensors.end(),
                                    [](const Json& each) { return each.contains("by"); });
  if (then_ && may_hear && !robot.contains("heard")) {
    is_new |= show(row++, {{}, tr("heard"), tr("messages")}, {{}, tr("not stored"), {}});
  }
  for (const Json& heard : member(robot, "heard")) {
    const QString from = text_of(heard, "from"), kind = text_of(heard, "kind");
    const QStringList of{text_of(heard, "by"),
                         from.isEmpty() ? tr("heard") : tr("heard from %1").arg(from)};
    if (member(heard, "fields").empty()) is_new |= show(row++, of + QStringList{kind}, {});
    for (const Json& field : member(heard, "fields")) {
      for (const Row& each : rows_of(field)) {
        is_new |= show(row++, of + QStringList{kind + u'.' + each.name}, each);
      }
    }
  }
  return row;
}

std::vector<SensorsPanel::Row> SensorsPanel::rows_of(const Json& field) const {
  const QString name = text_of(field, "name"), unit = text_of(field, "unit");
  const QString of_unit = unit.isEmpty() ? QString() : u' ' + unit;
  std::vector<double> values;
  for (const Json& value : member(field, "values")) {
    values.push_back(value.is_number() ? value.get<double>() : kAbsent);
  }
  const auto text = [&](std::size_t i) {
    return i < values.size() && std::isfinite(values[i]) ? number_text(values[i]) + of_unit
                                                         : QStringLiteral("-");
  };
  if (!field.contains("size")) {
    return {{name, text(0), {}}};
  }
  const auto size = static_cast<std::size_t>(std::max(integer_of(field, "size", 0), 0));
  if (size > kMostRows) {
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    const QString range =
        values.empty() ? QStringLiteral("-")
                       : tr("%1 to %2").arg(number_text(*least), number_text(*greatest)) + of_unit;
    return {{tr("%1 (%2)").arg(name).arg(values.size()), range, std::move(values)}};
  }
  std::vector<Row> rows;
  for (std::size_t i = 0; i < size; ++i) {
    rows.push_back({name + u'.' + QString::number(i), text(i), {}});
  }
  return rows;
}

bool SensorsPanel::show(int row, const QStringList& of, const Row& what) {
  auto* item = table_->topLevelItem(row);
  bool is_new = item == nullptr;
  if (is_new) {
    item = new QTreeWidgetItem(table_);
    item->setTextAlignment(3, Qt::AlignRight | Qt::AlignVCenter);
  }
  const QStringList cells = of + QStringList{what.text};
  for (int cell = 0; cell < cells.size(); ++cell) {
    if (item->text(cell) != cells[cell]) {
      item->setText(cell, cells[cell]);
      is_new = is_new || cell < 3;
    }
  }
  item->setData(3, Qt::DecorationRole, what.strip.empty() ? QVariant() : strip_of(what.strip));
  return is_new;
}

/// A bar for each number, or for the mean of those that share a column of pixels.
QPixmap SensorsPanel::strip_of(const std::vector<double>& values) const {
  const QSize size = table_->iconSize();
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double least = std::min(*low, 0.0), range = std::max(*high, 0.0) - least;
  const auto columns = std::min(values.size(), static_cast<std::size_t>(size.width()));
  QPixmap strip(size);
  strip.fill(Qt::transparent);
  QPainter painter(&strip);
  for (std::size_t i = 0; i < columns && range > 0.0; ++i) {
    const std::size_t begin = i * values.size() / columns, end = (i + 1) * values.size() / columns;
    const double mean = std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(begin),
                                        values.begin() + static_cast<std::ptrdiff_t>(end), 0.0) /
                        static_cast<double>(end - begin);
    const double wide = static_cast<double>(size.width()) / static_cast<double>(columns);
    const double y = size.height() * (1.0 - (mean - least) / range);
    const double zero = size.height() * (1.0 + least / range);
    painter.fillRect(
        QRectF(static_cast<double>(i) * wide, std::min(y, zero), wide, std::abs(zero - y)),
        palette().color(QPalette::Highlight));
  }
  return strip;
}

void SensorsPanel::filter() {
  for (int row = 0; row < table_->topLevelItemCount(); ++row) {
    auto* item = table_->topLevelItem(row);
    const QString all = item->text(0) + u' ' + item->text(1) + u' ' + item->text(2);
    item->setHidden(!all.contains(filter_->text(), Qt::CaseInsensitive));
  }
}

}  // namespace elsie::desktop

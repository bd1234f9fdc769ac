#include "watch/plots_panel.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPainter>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSplitter>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "elsie/files/write_whole.h"
#include "elsie/output/csv_line.h"
#include "elsie/picture/plot.h"

#include "paint/axes.h"
#include "watch/state.h"

namespace elsie::desktop {
namespace {

constexpr std::size_t kMostSamples = 6000;  // samples of a number: 200 s at 30 per second
constexpr int kName = Qt::UserRole;
constexpr int kStrip_lines = 7;  // the least height of a strip

class Plot : public QWidget, public ShowsFigures {
 public:
  explicit Plot(const PlotsPanel* panel) : panel_(panel) {
    setObjectName(QStringLiteral("plot"));
    setBackgroundRole(QPalette::Base);
    setAutoFillBackground(true);
    setAccessibleName(PlotsPanel::tr("Plot of the chosen numbers over time in s"));
    offer_figures(this);
  }

  Figures figures() const override { return panel_->figures(); }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    panel_->draw(painter, rect());
  }

 private:
  const PlotsPanel* panel_;
};

/// The unit of a number, from the last part of its name; "" if it has none, or if it is unknown.
QString unit_of(const QString& name) {
  const QString last = name.section(u'/', -1);
  if (last == u"speed" || last == u"forward" || last == u"lateral") {
    return QStringLiteral("m/s");
  }
  if (last == u"turn") {
    return QStringLiteral("rad/s");
  }
  return last == u"distance" ? QStringLiteral("m") : QString();
}

QString title_of(const QString& name) {
  const QString unit = unit_of(name);
  return unit.isEmpty() ? name : QStringLiteral("%1 [%2]").arg(name, unit);
}

}  // namespace

PlotsPanel::PlotsPanel(QWidget* parent)
    : QWidget(parent), tree_(new QTreeWidget(this)), plot_(new Plot(this)) {
  setObjectName(QStringLiteral("plots"));
  tree_->setObjectName(QStringLiteral("plots_tree"));
  tree_->setAccessibleName(tr("Numbers to plot"));
  tree_->setToolTip(tr("Space or a click on the box plots a number"));
  tree_->setHeaderHidden(true);
  setFocusProxy(tree_);
  auto* save_button = new QToolButton(this);
  save_button->setObjectName(QStringLiteral("plots_save"));
  save_button->setText(tr("Save..."));
  save_button->setToolTip(tr(
      "Save the plot as PNG or SVG, or its numbers as CSV: the samples that the window received, "
      "at most 30 per second on the clock. 'Record the next run' writes samples at equal times."));
  connect(save_button, &QToolButton::clicked, this, [this] {
    QFileDialog dialog(this, tr("Save plot: %1").arg(sampling()), {},
                       tr("Pictures or tables (*.png *.svg *.csv)"));
    dialog.setObjectName("save_plot_dialog");
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    const bool is_agreed = dialog.exec() == QDialog::Accepted;
    const QString file = is_agreed ? dialog.selectedFiles().front() : QString();
    if (const QString why = file.isEmpty() ? QString() : save(file); !why.isEmpty()) {
      QMessageBox::warning(this, tr("Save plot"),
                           tr("The plot was not saved as '%1': %2").arg(file, why));
    }
  });
  auto* left = new QWidget(this);
  auto* left_column = new QVBoxLayout(left);
  left_column->setContentsMargins(0, 0, 0, 0);
  left_column->addWidget(tree_);
  left_column->addWidget(save_button);
  auto* halves = new QSplitter(this);
  auto* area = new QScrollArea(this);
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setWidget(plot_);
  halves->addWidget(left);
  halves->addWidget(area);
  halves->setStretchFactor(1, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(halves);
  connect(tree_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
    const QString name = item->data(0, kName).toString();
    item->checkState(0) == Qt::Checked ? void(chosen_.insert(name)) : void(chosen_.erase(name));
    fit();
    Q_EMIT choice_changed();
  });
}

void PlotsPanel::add(const Json& state) {
  const double time = number_of(state, "time_s");
  if (!std::isfinite(time)) {
    return;
  }
  if (time < time_) {
    begin();
  } else if (time == time_) {
    return;
  }
  time_ = time;
  for (const Json& robot : member(state, "robots")) {
    collect(robot, text_of(robot, "id"), time);
  }
  collect(member(state, "measures"), tr("measures"), time);
  plot_->update();
}

void PlotsPanel::collect(const Json& value, const QString& path, double time) {
  static const std::set<std::string> kCommands{"command", "asked", "possible"};
  static const std::set<std::string> kLeftOut{"depth", "parent", "inhibited_by", "cameras"};
  static const std::array<QString, 3> kParts{QStringLiteral("forward"), QStringLiteral("lateral"),
                                             QStringLiteral("turn")};
  for (const auto& [key, inner] : value.items()) {
    const QString name = path + u'/' + QString::fromStdString(key);
    if (kLeftOut.contains(key)) {
      continue;
    }
    if (inner.is_number()) {
      record(name, inner, time);
    } else if (inner.is_object()) {
      collect(inner, name, time);
    } else if (inner.is_array() && kCommands.contains(key)) {
      for (std::size_t i = 0; i < std::min(inner.size(), kParts.size()); ++i) {
        record(name + u'/' + kParts[i], inner[i], time);
      }
    } else if (inner.is_array() && key == "values") {
      const Json& names = member(value, "names");
      for (std::size_t i = 0; i < inner.size(); ++i) {
        const bool named = i < names.size() && names[i].is_string();
        record(path + u'/' +
                   (named ? QString::fromStdString(names[i].get<std::string>())
                          : QString::number(i + 1)),
               inner[i], time);
      }
    } else if (inner.is_array()) {
      for (const Json& one : inner) {
        for (const char* id : {"path", "id", "name"}) {
          if (const QString part = text_of(one, id); !part.isEmpty()) {
            collect(one, path + u'/' + part, time);
            break;
          }
        }
      }
    }
  }
}

void PlotsPanel::record(const QString& path, const Json& value, double time) {
  auto [found, is_new] = curves_.try_emplace(path);
  if (is_new) {
    add_item(path);
  }
  Curve& curve = found->second;
  curve.emplace_back(
      time, value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN());
  if (curve.size() > kMostSamples) {
    curve.pop_front();
  }
}

void PlotsPanel::add_item(const QString& name) {
  const QSignalBlocker quiet(tree_);
  QTreeWidgetItem* parent = tree_->invisibleRootItem();
  QString path;
  for (const QString& part : name.split(u'/')) {
    path += (path.isEmpty() ? QString() : QStringLiteral("/")) + part;
    QTreeWidgetItem*& item = items_[path];
    if (item == nullptr) {
      item = new QTreeWidgetItem(parent, {part});
      item->setToolTip(0, path);
    }
    parent = item;
  }
  const QString unit = unit_of(name);
  parent->setToolTip(0, unit.isEmpty() ? name : tr("%1, in %2").arg(name, unit));
  parent->setFlags(parent->flags() | Qt::ItemIsUserCheckable);
  parent->setData(0, kName, name);
  parent->setCheckState(0, chosen_.contains(name) ? Qt::Checked : Qt::Unchecked);
  if (chosen_.contains(name)) fit();
}

void PlotsPanel::begin() {
  for (auto& [name, curve] : curves_) {
    curve.clear();
  }
  time_ = -1.0;
  plot_->update();
}

void PlotsPanel::clear() {
  const QSignalBlocker quiet(tree_);
  curves_.clear();
  items_.clear();
  tree_->clear();
  time_ = -1.0;
  fit();
}

QStringList PlotsPanel::names() const {
  QStringList all;
  for (const auto& [name, curve] : curves_) {
    all << name;
  }
  return all;
}

QTreeWidgetItem* PlotsPanel::item_of(const QString& name) const {
  const auto found = items_.find(name);
  return found == items_.end() ? nullptr : found->second;
}

QStringList PlotsPanel::chosen() const {
  QStringList all;
  for (const QString& name : chosen_) {
    if (curves_.contains(name)) {
      all << name;
    }
  }
  return all;
}

void PlotsPanel::set_choice(const QStringList& names) {
  chosen_ = {names.begin(), names.end()};
  for (const auto& [name, curve] : curves_) {
    choose(name, chosen_.contains(name));
  }
  fit();
}

QStringList PlotsPanel::chosen_robots() const {
  QStringList all;
  for (const QString& name : chosen_) {
    all << name.section(u'/', 0, 0);
  }
  all.removeDuplicates();
  return all;
}

void PlotsPanel::choose(const QString& name, bool on) {
  if (curves_.contains(name)) {
    item_of(name)->setCheckState(0, on ? Qt::Checked : Qt::Unchecked);
  }
}

std::vector<PlotsPanel::Strip> PlotsPanel::strips() const {
  std::vector<Strip> all;
  for (const QString& name : chosen()) {
    const QString unit = unit_of(name);
    const QString title =
        unit.isEmpty() ? name.section(u'/', -1) : QStringLiteral("[%1]").arg(unit);
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Strip& strip) { return strip.title == title; });
    (found == all.end() ? all.emplace_back(Strip{title, {}}) : *found).names << name;
  }
  return all;
}

/// Each strip stays high enough to be read; the plot scrolls instead.
void PlotsPanel::fit() {
  plot_->setMinimumHeight(static_cast<int>(strips().size()) * kStrip_lines *
                          fontMetrics().height());
  plot_->update();
}

void PlotsPanel::draw(QPainter& painter, const QRectF& area) const {
  const std::vector<Strip> all = strips();
  if (all.empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(area, Qt::AlignCenter, tr("Choose numbers to plot them"));
    return;
  }
  Span x{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const QFontMetricsF font = painter.fontMetrics();
  const double line = font.height();
  double legend = 0.0;
  for (const QString& name : chosen()) {
    legend = std::max(legend, font.horizontalAdvance(title_of(name)) + 4.0 * line);
    if (const Curve& curve = curves_.at(name); !curve.empty()) {
      x = {std::min(x.low, curve.front().x()), std::max(x.high, curve.back().x())};
    }
  }
  if (!(x.length() > 0.0)) {
    x = {std::isfinite(x.low) ? x.low : 0.0, (std::isfinite(x.low) ? x.low : 0.0) + 1.0};
  }
  legend = std::min(legend, area.width() / 3.0);
  const double height = area.height() / static_cast<double>(all.size());
  int n = 0;  // of the curve
  for (std::size_t i = 0; i < all.size(); ++i) {
    const QRectF strip(area.left(), area.top() + height * static_cast<double>(i), area.width(),
                       height);
    draw_strip(painter, strip, legend, all[i], x, n);
  }
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(area.adjusted(0, 0, -line / 2.0, 0), Qt::AlignBottom | Qt::AlignRight,
                   sampling());
}

/// `legend`: the width of the names beside it; `n`: the number of its first curve.
void PlotsPanel::draw_strip(QPainter& painter, const QRectF& area, double legend,
                            const Strip& strip, const Span& x, int& n) const {
  Span y{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const QString& name : strip.names) {
    for (const QPointF& point : curves_.at(name)) {
      if (std::isfinite(point.y())) {
        y = {std::min(y.low, point.y()), std::max(y.high, point.y())};
      }
    }
  }
  if (!std::isfinite(y.length())) {
    y = {};
  }
  const double room = y.length() > 0.0 ? 0.05 * y.length() : 0.5;
  y = {y.low - room, y.high + room};
  const double line = painter.fontMetrics().height();
  const Axes axes(painter, area.adjusted(0, 0, -legend, 0), x, y);
  axes.draw(painter, palette(), tr("time [s]"), strip.title);
  double middle = axes.area().top() + line * 0.5;
  for (const QString& name : strip.names) {
    const Curve& curve = curves_.at(name);
    const QPen pen(curve_colour(n, palette()), line / 9.0, pen_style(n));
    axes.draw_curve(painter, QPolygonF(QList<QPointF>(curve.begin(), curve.end())), pen);
    const double left = area.right() - legend + line / 2.0;
    painter.setPen(pen);
    painter.drawLine(QPointF(left, middle), QPointF(left + 2.5 * line, middle));
    painter.setPen(palette().color(QPalette::Text));
    const QRectF place(left + 3 * line, middle - line, area.right() - left - 3 * line, 2 * line);
    painter.drawText(place, Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(title_of(name), Qt::ElideMiddle,
                                                      static_cast<int>(place.width())));
    middle += 1.2 * line;
    ++n;
  }
}

QString PlotsPanel::sampling() const {
  qsizetype count = 0;
  double widest_s = 0.0;
  for (const QString& name : chosen()) {
    const Curve& curve = curves_.at(name);
    count = std::max(count, static_cast<qsizetype>(curve.size()));
    for (std::size_t i = 1; i < curve.size(); ++i) {
      widest_s = std::max(widest_s, curve[i].x() - curve[i - 1].x());
    }
  }
  return tr("%1 samples, up to %2 s apart").arg(count).arg(number_text(widest_s));
}

QString PlotsPanel::save(const QString& file) const {
  const QString ending = QFileInfo(file).suffix().toLower();
  if (chosen().isEmpty()) {
    return tr("No number is chosen. Check the numbers to save in the tree.");
  }
  if (ending == u"csv") {
    const int error = files::write_whole(file.toStdString(), table(), files::Durable::yes);
    return error == 0 ? QString() : qt_error_string(error);
  }
  if (ending != u"png" && ending != u"svg") {
    return tr("The name must end in .png, .svg or .csv.");
  }
  try {
    picture::Page page;
    for (const Strip& strip : strips()) {
      page.rows.push_back({.panels = {chart(strip)}, .aspect = 0.5});
    }
    picture::save_page(page, file.toStdString());
  } catch (const std::exception& error) {
    return QString::fromUtf8(error.what());
  }
  return {};
}

picture::LineChart PlotsPanel::chart(const Strip& strip) const {
  picture::LineChart chart{.x = {.label = tr("time").toStdString(), .unit = "s"}};
  chart.y.unit = unit_of(strip.names.front()).toStdString();
  for (const QString& name : strip.names) {
    picture::Series& series = chart.series.emplace_back();
    series.name = title_of(name).toStdString();
    for (const QPointF& point : curves_.at(name)) {
      series.points.push_back({point.x(), point.y()});
    }
  }
  return chart;
}

Figures PlotsPanel::figures() const {
  Figures figures{{tr("number"), tr("now"), tr("least"), tr("most"), tr("from [s]"), tr("to [s]")},
                  {}};
  for (const QString& name : chosen()) {
    const Curve& curve = curves_.at(name);
    if (curve.empty()) {
      figures.rows.push_back({title_of(name)});
      continue;
    }
    const auto [least, most] =
        std::minmax_element(curve.begin(), curve.end(),
                            [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); });
    figures.rows.push_back({title_of(name), number_text(curve.back().y()), number_text(least->y()),
                            number_text(most->y()), number_text(curve.front().x()),
                            number_text(curve.back().x())});
  }
  return figures;
}

std::string PlotsPanel::table() const {
  const QStringList shown = chosen();
  std::map<double, std::vector<double>> rows;
  for (int n = 0; n < shown.size(); ++n) {
    for (const QPointF& point : curves_.at(shown[n])) {
      std::vector<double>& row = rows[point.x()];
      row.resize(static_cast<std::size_t>(shown.size()), std::nan(""));
      row[static_cast<std::size_t>(n)] = point.y();
    }
  }
  output::CsvLine line;
  line.text("time_s");
  for (const QString& name : shown) {
    line.text(name.toStdString());
  }
  std::string text = line.take() + '\n';
  for (const auto& [time, row] : rows) {
    line.number(time);
    for (const double value : row) {
      std::isfinite(value) ? line.number(value) : line.empty();
    }
    text += line.take() + '\n';
  }
  return text;
}

}  // namespace elsie::desktop

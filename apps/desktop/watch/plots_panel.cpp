#include "watch/plots_panel.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSplitter>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "elsie/files/csv_line.h"
#include "elsie/files/write_whole.h"
#include "elsie/picture/plot.h"

#include "paint/chart.h"

namespace elsie::desktop {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr int kName = Qt::UserRole;
constexpr double kSaved_px = 8000.0;  // finer than any picture
constexpr int kStrip_lines = 8;       // the least height of a strip

class Plot : public QWidget, public ShowsFigures {
 public:
  explicit Plot(PlotsPanel* panel) : panel_(panel) {
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
    panel_->draw(painter, rect());
  }

  void mousePressEvent(QMouseEvent* event) override {
    is_dragged_ = event->button() == Qt::LeftButton;
    wish(event->position());
  }
  void mouseMoveEvent(QMouseEvent* event) override { wish(event->position()); }
  void mouseReleaseEvent(QMouseEvent*) override { is_dragged_ = false; }

 private:
  void wish(const QPointF& at) {
    const auto time_s = is_dragged_ ? panel_->time_at(at, size()) : std::nullopt;
    if (time_s) Q_EMIT panel_->time_wished(*time_s);
  }

  PlotsPanel* panel_;
  bool is_dragged_ = false;
};

/// The number with the fewest digits that is this value in single precision.
double shortest(float value) {
  std::array<char, 64> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  double number = 0.0;
  std::from_chars(digits.data(), end, number);
  return number;
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
      "Save the plot as PNG or SVG, or its numbers as CSV: the samples of the run at equal times, "
      "whatever its speed. A long run keeps fewer of them."));
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

void PlotsPanel::set_samples(const Samples& samples) {
  samples_ = &samples;
  plot_->update();
}

void PlotsPanel::look_back(std::optional<double> time_s) {
  if (time_s != std::exchange(looked_back_to_s_, time_s)) plot_->update();
}

std::optional<double> PlotsPanel::place_of(double time_s, const QSizeF& size) const {
  const std::vector<picture::LineChart> all = charts(size.width());
  if (all.empty()) return std::nullopt;
  const QRectF strip(QPointF(),
                     QSizeF(size.width(), size.height() / static_cast<double>(all.size())));
  const PlotPlace place = plot_place(strip, all.front(), fontMetrics());
  const double part = (time_s - place.x.low) / place.x.length();
  return part >= 0.0 && part <= 1.0 ? std::optional(place.plot.left() + part * place.plot.width())
                                    : std::nullopt;
}

std::optional<double> PlotsPanel::time_at(const QPointF& at, const QSizeF& size) const {
  const std::vector<picture::LineChart> all = charts(size.width());
  if (all.empty() || !samples_ || samples_->times().empty()) return std::nullopt;
  const double height = size.height() / static_cast<double>(all.size());
  const auto n = static_cast<std::size_t>(
      std::clamp(at.y() / height, 0.0, static_cast<double>(all.size()) - 1.0));
  const QRectF strip(QPointF(), QSizeF(size.width(), height));
  const PlotPlace place = plot_place(strip, all[n], fontMetrics());
  const double part = (at.x() - place.plot.left()) / place.plot.width();
  if (part < 0.0 || part > 1.0) return std::nullopt;
  return std::clamp(place.x.low + part * place.x.length(), samples_->times().front(),
                    samples_->times().back());
}

QString PlotsPanel::value_then(const QString& name) const {
  return looked_back_to_s_ && samples_ ? number_text(samples_->at(name, *looked_back_to_s_))
                                       : QString();
}

void PlotsPanel::paint_cursor(QPainter& painter, const QRectF& strip,
                              const picture::LineChart& chart) const {
  const PlotPlace place = plot_place(strip, chart, fontMetrics());
  const double part = (*looked_back_to_s_ - place.x.low) / place.x.length();
  if (part < 0.0 || part > 1.0) return;
  const double x = std::round(place.plot.left() + part * place.plot.width());
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
  painter.drawLine(QPointF(x, place.plot.top()), QPointF(x, place.plot.bottom()));
}

void PlotsPanel::set_names(const QStringList& names, const QHash<QString, QString>& units) {
  units_ = units;
  const std::set<QString> all(names.begin(), names.end());
  if (!std::includes(all.begin(), all.end(), names_.begin(), names_.end())) {
    const QSignalBlocker quiet(tree_);
    items_.clear();
    tree_->clear();
    names_.clear();
  }
  for (const QString& name : names) {
    if (names_.insert(name).second) {
      add_item(name);
    }
  }
  fit();
}

template <class See>
void PlotsPanel::visit(const QString& name, const See& see) const {
  const std::vector<float>* const values = samples_ ? samples_->curve(name) : nullptr;
  for (std::size_t i = 0; values && i < values->size(); ++i) {
    if (std::isfinite((*values)[i])) {
      see(samples_->times()[i], (*values)[i]);
    }
  }
}

QPolygonF PlotsPanel::polygon(const QString& name, const Span& x, double width) const {
  QPolygonF points;
  const std::vector<float>* const values = samples_ ? samples_->curve(name) : nullptr;
  const auto column = [&](std::size_t i) {
    return std::floor((samples_->times()[i] - x.low) / x.length() * width);
  };
  const auto point = [&](std::size_t i) { return QPointF(samples_->times()[i], (*values)[i]); };
  for (std::size_t begin = 0, end = 0; values && begin < values->size(); begin = end) {
    std::array<std::size_t, 4> kept;  // first, least, greatest, last
    kept.fill(begin);
    const bool is_whole = std::isfinite((*values)[begin]);  // else it interrupts the curve
    for (end = begin + 1; is_whole && end < values->size() && std::isfinite((*values)[end]) &&
                          column(end) == column(begin);
         ++end) {
      kept[1] = (*values)[end] < (*values)[kept[1]] ? end : kept[1];
      kept[2] = (*values)[end] > (*values)[kept[2]] ? end : kept[2];
      kept[3] = end;
    }
    std::sort(kept.begin(), kept.end());
    std::for_each(kept.begin(), std::unique(kept.begin(), kept.end()),
                  [&](std::size_t i) { points << point(i); });
  }
  return points;
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
  const QString unit = units_.value(name);
  parent->setToolTip(0, unit.isEmpty() ? name : tr("%1, in %2").arg(name, unit));
  parent->setFlags(parent->flags() | Qt::ItemIsUserCheckable);
  parent->setData(0, kName, name);
  parent->setCheckState(0, chosen_.contains(name) ? Qt::Checked : Qt::Unchecked);
}

QString PlotsPanel::title_of(const QString& name) const {
  const QString unit = units_.value(name);
  return unit.isEmpty() ? name : QStringLiteral("%1 [%2]").arg(name, unit);
}

QStringList PlotsPanel::names() const { return {names_.begin(), names_.end()}; }

QStringList PlotsPanel::chosen() const {
  QStringList all;
  for (const QString& name : chosen_) {
    if (names_.contains(name)) {
      all << name;
    }
  }
  return all;
}

void PlotsPanel::set_choice(const QStringList& names) {
  chosen_ = {names.begin(), names.end()};
  for (const QString& name : names_) {
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
  if (names_.contains(name)) {
    items_[name]->setCheckState(0, on ? Qt::Checked : Qt::Unchecked);
  }
}

std::vector<PlotsPanel::Strip> PlotsPanel::strips() const {
  std::vector<Strip> all;
  for (const QString& name : chosen()) {
    const QString unit = units_.value(name);
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
  const double height = area.height() / static_cast<double>(all.size());
  QRectF strip(area.topLeft(), QSizeF(area.width(), height));
  const std::vector<picture::LineChart> shown = charts(area.width());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    picture::LineChart chart = shown[i];
    for (std::size_t k = 0; looked_back_to_s_ && k < chart.series.size(); ++k) {
      chart.series[k].name += " = " + value_then(all[i].names[static_cast<int>(k)]).toStdString();
    }
    draw_chart(painter, strip, chart, palette());
    if (looked_back_to_s_) paint_cursor(painter, strip, chart);
    strip.translate(0.0, height);
  }
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(area.adjusted(0, 0, -0.5 * painter.fontMetrics().height(), 0),
                   Qt::AlignBottom | Qt::AlignRight, sampling());
}

QString PlotsPanel::sampling() const {
  int most = 0;
  double widest_s = 0.0;
  for (const QString& name : chosen()) {
    int count = 0;
    double before_s = 0.0;
    visit(name, [&](double time_s, double) {
      widest_s = count > 0 ? std::max(widest_s, time_s - before_s) : widest_s;
      before_s = time_s;
      ++count;
    });
    most = std::max(most, count);
  }
  return tr("%1 samples, up to %2 s apart").arg(most).arg(number_text(widest_s));
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
    for (picture::LineChart& chart : charts(kSaved_px)) {
      page.rows.push_back({.panels = {std::move(chart)}, .aspect = 0.5});
    }
    picture::save_page(page, file.toStdString());
  } catch (const std::exception& error) {
    return QString::fromUtf8(error.what());
  }
  return {};
}

std::vector<picture::LineChart> PlotsPanel::charts(double width) const {
  Span x{kFar, -kFar};
  for (const QString& name : chosen()) {
    visit(name, [&](double time_s, double) {
      x = {std::min(x.low, time_s), std::max(x.high, time_s)};
    });
  }
  std::vector<picture::LineChart> all;
  std::size_t n = 0;  // of the curve
  for (const Strip& strip : strips()) {
    picture::LineChart& chart = all.emplace_back();
    chart.x = {.label = tr("time").toStdString(), .unit = "s"};
    if (x.length() > 0.0) {
      chart.x.low = x.low;
      chart.x.high = x.high;
    }
    chart.y.unit = units_.value(strip.names.front()).toStdString();
    chart.y.label = chart.y.unit.empty() ? strip.title.toStdString() : std::string();
    for (const QString& name : strip.names) {
      picture::Series& series = chart.series.emplace_back();
      series.name = title_of(name).toStdString();
      series.colour = n++;
      for (const QPointF& point : polygon(name, x, width)) {
        series.points.push_back({point.x(), point.y()});
      }
    }
  }
  return all;
}

Figures PlotsPanel::figures() const {
  const QString when =
      looked_back_to_s_ ? tr("at %1 s").arg(*looked_back_to_s_, 0, 'f', 2) : tr("now");
  Figures figures{{tr("number"), when, tr("least"), tr("most"), tr("from [s]"), tr("to [s]")}, {}};
  for (const QString& name : chosen()) {
    const std::vector<float>* const values = samples_ ? samples_->curve(name) : nullptr;
    if (!values || values->empty()) {
      figures.rows.push_back({title_of(name)});
      continue;
    }
    Span range{kFar, -kFar};
    visit(name, [&](double, double value) {
      range = {std::min(range.low, value), std::max(range.high, value)};
    });
    const QString then = looked_back_to_s_ ? value_then(name) : number_text(values->back());
    figures.rows.push_back({title_of(name), then, number_text(range.low), number_text(range.high),
                            number_text(samples_->times().front()),
                            number_text(samples_->times().back())});
  }
  return figures;
}

std::string PlotsPanel::table() const {
  files::CsvLine line;
  line.text("time_s");
  std::vector<const std::vector<float>*> curves;
  for (const QString& name : chosen()) {
    line.text(name.toStdString());
    curves.push_back(samples_ ? samples_->curve(name) : nullptr);
  }
  std::string text = line.take() + '\n';
  const auto has_value = [](const std::vector<float>* curve, std::size_t i) {
    return curve && std::isfinite((*curve)[i]);
  };
  for (std::size_t i = 0; samples_ && i < samples_->times().size(); ++i) {
    if (std::none_of(curves.begin(), curves.end(),
                     [&](const auto* curve) { return has_value(curve, i); })) {
      continue;
    }
    line.number(files::tidy_time(samples_->times()[i]));
    for (const std::vector<float>* curve : curves) {
      has_value(curve, i) ? line.number(shortest((*curve)[i])) : line.empty();
    }
    text += line.take() + '\n';
  }
  return text;
}

}  // namespace elsie::desktop

#include "watch/fuzzy_panel.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "elsie/fuzzy/fcl.h"

#include "paint/axes.h"
#include "paint/boxes.h"
#include "paint/chart.h"
#include "paint/figures.h"
#include "watch/control_surface.h"
#include "watch/fuzzy_instant.h"
#include "watch/state.h"

namespace elsie::desktop {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::vector<Vector2> points_of(const FuzzySet& set) {
  std::vector<Vector2> points;
  for (const auto& point : set.points) {
    points.push_back({point.x, point.degree});
  }
  return points;
}

}  // namespace

/// Draws one model.
class FuzzyPanel::Page : public QWidget, public ShowsFigures {
 public:
  std::optional<fuzzy::Model> model;
  QString problem;
  std::map<std::string, double> inputs;
  std::map<std::string, double> outputs;
  FuzzyInstant now;

  /// The inputs in the model's order; empty if one is missing.
  std::vector<double> values() const {
    std::vector<double> all;
    for (const fuzzy::Variable& input : model->inputs()) {
      const auto found = inputs.find(input.name);
      if (found == inputs.end() || !std::isfinite(found->second)) {
        return {};
      }
      all.push_back(found->second);
    }
    return all;
  }

  Figures figures() const override {
    Figures figures{{tr("what"), tr("value")}, {}};
    if (!model) {
      return figures;
    }
    const auto add = [&](const std::string& name, double value) {
      figures.rows.push_back({QString::fromStdString(name), number_text(value)});
    };
    for (const auto& [name, value] : inputs) add(name, value);
    for (std::size_t i = 0; i < model->rules().size() && i < now.degrees.size(); ++i) {
      add(model->rules()[i].text, now.degrees[i]);
    }
    for (const auto& [name, value] : outputs) add(name, value);
    return figures;
  }

  /// Computes what is drawn.
  void think() {
    now = model ? fuzzy_instant(*model, values()) : FuzzyInstant();
    update();
  }

  /// The height that all of it needs at this width.
  void fit() {
    int height = row_height();
    if (model) {
      height += plot_height() * static_cast<int>(model->inputs().size() + model->outputs().size());
      for (std::size_t i = 0; i < model->rules().size(); ++i) height += rule_height(i);
    }
    setMinimumHeight(height);
    think();
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QWidget::resizeEvent(event);
    fit();
  }

  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    if (!model) {
      painter.setPen(palette().color(QPalette::PlaceholderText));
      painter.drawText(
          rect(), Qt::AlignCenter | Qt::TextWordWrap,
          problem.isEmpty() ? tr("No fuzzy model of this robot has decided yet") : problem);
      return;
    }
    int top = 0;
    if (!now.problem.isEmpty()) {
      painter.setPen(palette().color(QPalette::Text));
      painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, now.problem);
      return;
    }
    const auto draw = [&](const picture::LineChart& chart) {
      draw_chart(painter, QRectF(0, top, width(), plot_height()), chart, palette());
      top += plot_height();
    };
    for (std::size_t i = 0; i < model->inputs().size(); ++i) {
      draw(
          chart_of(model->inputs()[i], i < now.inputs.size() ? now.inputs[i] : kNone, nullptr, {}));
    }
    const int line = row_height();
    for (std::size_t i = 0; i < model->rules().size(); ++i) {
      const double degree = i < now.degrees.size() ? std::clamp(now.degrees[i], 0.0, 1.0) : 0.0;
      const QRectF bar(em() / 2.0, top + 2, 3.0 * em(), line - 4);
      painter.fillRect(QRectF(bar.topLeft(), QSizeF(bar.width() * degree, bar.height())),
                       curve_colour(0, palette()));
      painter.setPen(palette().color(QPalette::Text));
      painter.drawRect(bar);
      painter.drawText(QRect(4 * em(), top, kFigure_em * em(), line), Qt::AlignVCenter,
                       number_text(std::round(100 * degree) / 100));
      painter.drawText(rule_place(top, rule_height(i)), Qt::AlignVCenter | Qt::TextWordWrap,
                       QString::fromStdString(model->rules()[i].text));
      top += rule_height(i);
    }
    static const FuzzySet kNothing;
    for (std::size_t i = 0; i < model->outputs().size(); ++i) {
      const auto& output = model->outputs()[i];
      const auto given = outputs.find(output.name);
      const bool is_known = i < now.sets.size();
      draw(chart_of(output, given == outputs.end() ? kNone : given->second,
                    is_known ? &now.sets[i] : &kNothing, is_known ? now.centres[i] : std::nullopt));
    }
  }

 private:
  static constexpr int kFigure_em = 3;  // "0.25"
  static constexpr int kPlot_lines = 12;

  int em() const { return fontMetrics().horizontalAdvance(u'm'); }
  int row_height() const { return fontMetrics().height() * 4 / 3; }

  /// Beside its bar and its degree.
  QRect rule_place(int top, int height) const {
    const int left = (4 + kFigure_em) * em();
    return {left, top, std::max(width() - left, 8 * em()), height};
  }
  int rule_height(std::size_t rule) const {
    const QRect whole = rule_place(0, 100 * row_height());
    const QRect needed = fontMetrics().boundingRect(
        whole, Qt::TextWordWrap, QString::fromStdString(model->rules()[rule].text));
    return needed.height() - fontMetrics().height() + row_height();
  }

  int plot_height() const { return fontMetrics().height() * kPlot_lines; }

  /// A variable with its terms, its value, and for an output its accumulated set `cut`, which is
  /// empty while it is unknown, with its centre of gravity.
  picture::LineChart chart_of(const fuzzy::Variable& variable, double value, const FuzzySet* cut,
                              std::optional<double> centre) const {
    picture::LineChart chart;
    chart.title = variable.name + " = " + number_text(value).toStdString();
    chart.x = axis_of(variable);
    chart.x.label.clear();
    chart.y = {"", "", 0.0, 1.0};
    chart.naming = picture::Naming::at_peak;
    for (const fuzzy::Term& term : variable.terms) {
      const double degree = std::round(100 * term.set.degree(value)) / 100;
      if (cut == nullptr && std::isfinite(value) && degree > 0.0) {
        chart.title += "   " + term.name + " " + number_text(degree).toStdString();
      }
      chart.series.push_back({term.name, points_of(term.set)});
    }
    const auto add = [&](std::vector<Vector2> points) -> picture::Series& {
      picture::Series& series = chart.series.emplace_back();
      series.points = std::move(points);
      series.colour = picture::kNeutral;
      return series;
    };
    if (std::isfinite(value)) {
      add({{value, 0.0}, {value, 1.0}});  // the first neutral one is solid
    }
    if (cut != nullptr) {
      add(points_of(*cut)).filled = true;
    }
    if (centre) {
      chart.title +=
          QCoreApplication::translate("elsie::desktop::FuzzyPanel", "   centre of gravity %1")
              .arg(number_text(std::round(1000 * *centre) / 1000))
              .toStdString();
      picture::Series& mark = add({{*centre, 0.0}});
      mark.colour = 0;
      mark.joining = picture::Joining::nothing;
      mark.marked = true;
    }
    return chart;
  }
};

FuzzyPanel::FuzzyPanel(QWidget* parent)
    : QWidget(parent),
      notice_(new QLabel(this)),
      models_(new QComboBox(this)),
      edit_(new QPushButton(tr("Edit..."), this)),
      page_(new Page),
      surface_(new ControlSurface) {
  setObjectName(QStringLiteral("fuzzy"));
  notice_->setObjectName(QStringLiteral("fuzzy_notice"));
  notice_->setWordWrap(true);
  notice_->hide();
  models_->setObjectName(QStringLiteral("fuzzy_models"));
  models_->setAccessibleName(tr("Fuzzy model"));
  quiet_wheel(models_);
  edit_->setObjectName(QStringLiteral("edit_model"));
  edit_->setToolTip(tr("Opens the rules and terms of this model as a text"));
  edit_->setEnabled(false);
  connect(edit_, &QPushButton::clicked, this,
          [this] { Q_EMIT edit_wished(models_->currentData().toStringList().value(0)); });
  page_->setObjectName(QStringLiteral("fuzzy_page"));
  page_->setAccessibleName(tr("Inputs, rules and outputs of the fuzzy model"));
  offer_figures(page_);
  page_->setBackgroundRole(QPalette::Base);
  auto* whole = new QWidget;
  whole->setBackgroundRole(QPalette::Base);
  auto* parts = new QVBoxLayout(whole);
  parts->setContentsMargins(0, 0, 0, 0);
  parts->addWidget(page_);
  parts->addWidget(surface_, 1);
  auto* area = new QScrollArea(this);
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);  // all of it gives way
  area->setWidget(whole);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* top = new QHBoxLayout;
  top->addWidget(models_, 1);
  top->addWidget(edit_);
  column->addLayout(top);
  column->addWidget(notice_);
  column->addWidget(area);
  connect(models_, &QComboBox::currentIndexChanged, this, [this] {
    load();
    show_values();
  });
}

FuzzyPanel::~FuzzyPanel() = default;

void FuzzyPanel::set_robot(const QString& id) {
  if (id != robot_) {
    robot_ = id;
    empty();
  }
}

void FuzzyPanel::clear() {
  read_.clear();
  empty();
}

void FuzzyPanel::empty() {
  present_.clear();
  models_->clear();
  load();
}

FuzzyPanel::Reading FuzzyPanel::read(const QStringList& source) {
  try {
    return {fuzzy::read_fcl(source[0].toStdString(), source[1].toStdString()), {}};
  } catch (const std::exception& error) {
    return {std::nullopt, QString::fromUtf8(error.what())};
  }
}

const FuzzyPanel::Reading& FuzzyPanel::reading_of(const QStringList& source) {
  const auto known = read_.find(source);
  return known != read_.end() ? known->second : read_.emplace(source, read(source)).first->second;
}

void FuzzyPanel::load() {
  surface_->set_model(nullptr);
  page_->model.reset();
  page_->problem.clear();
  page_->inputs.clear();
  page_->outputs.clear();
  const QStringList source = models_->currentData().toStringList();
  edit_->setEnabled(source.size() == 2);
  if (source.size() == 2) {
    const Reading& reading = reading_of(source);
    page_->model = reading.model;
    page_->problem = reading.problem;
  }
  page_->fit();
  surface_->set_model(page_->model ? &*page_->model : nullptr);
}

void FuzzyPanel::read_again() {
  for (auto& [source, reading] : read_) reading = read(source);
  load();
  show_values();
}

QString FuzzyPanel::mistake_in(const QString& file) const {
  std::vector<QStringList> sources;
  const auto add = [&](const QStringList& source) {
    if (QFileInfo(source[0]) == QFileInfo(file)) sources.push_back(source);
  };
  for (int i = 0; i < models_->count(); ++i) add(models_->itemData(i).toStringList());
  if (sources.empty()) {  // a model of another robot
    for (const auto& [source, reading] : read_) add(source);
  }
  if (sources.empty()) add({file, {}});
  for (const QStringList& source : sources) {
    if (QString mistake = read(source).problem; !mistake.isEmpty()) return mistake;
  }
  return {};
}

void FuzzyPanel::add(const Json& state) {
  std::map<QString, int> times;  // a path may occur several times
  for (const Json& entry : member(robot_of(state, robot_), "fuzzy")) {
    const QString path = text_of(entry, "path");
    const int count = ++times[path];
    const QString name = count == 1 ? path : QStringLiteral("%1 (%2)").arg(path).arg(count);
    const QStringList source{text_of(entry, "file"), text_of(entry, "block")};
    present_[name] = entry;
    reading_of(source);  // before it is edited
    if (const int place = models_->findText(name); place < 0) {
      models_->addItem(name, source);
    } else if (models_->itemData(place).toStringList() != source) {
      models_->setItemData(place, source);
      if (place == models_->currentIndex()) load();
    }
  }
  show_values();
}

void FuzzyPanel::look_back(const Instant* then) {
  then_ = then ? std::optional(*then) : std::nullopt;
  show_values();
}

void FuzzyPanel::show_values() {
  const QString name = models_->currentText();
  bool is_stored = false;
  const auto take = [&](const char* list, std::map<std::string, double>& values) {
    for (const auto& [key, value] : member(present_[name], list).items()) {
      const QString number =
          QStringList{robot_, name, list, QString::fromStdString(key)}.join(u'/');
      values[key] =
          then_ ? then_->number(number) : number_of(member(present_[name], list), key.c_str());
      is_stored = is_stored || std::isfinite(values[key]);
    }
  };
  take("inputs", page_->inputs);
  take("outputs", page_->outputs);
  notice_->setVisible(then_ && !is_stored && page_->model);
  if (then_) {
    notice_->setText(
        tr("The values at %1 s are not stored: they are while this window is shown and "
           "the model is asked.")
            .arg(then_->time_s, 0, 'f', 2));
  }
  page_->think();
  surface_->set_inputs(page_->now.inputs);
}

QString FuzzyPanel::notice() const { return notice_->isHidden() ? QString() : notice_->text(); }
const FuzzyInstant& FuzzyPanel::now() const { return page_->now; }
QString FuzzyPanel::problem() const {
  return page_->problem.isEmpty() ? page_->now.problem : page_->problem;
}

}  // namespace elsie::desktop

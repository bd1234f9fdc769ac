#include "watch/fuzzy_panel.h"

#include <QComboBox>
#include <QPainter>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "elsie/fuzzy/fcl.h"
#include "elsie/fuzzy/sets.h"

#include "paint/axes.h"
#include "paint/boxes.h"
#include "paint/figures.h"
#include "watch/control_surface.h"
#include "watch/fuzzy_instant.h"
#include "watch/state.h"

namespace elsie::desktop {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

QPolygonF polygon(const FuzzySet& set) {
  QPolygonF points;
  for (const auto& point : set.points) {
    points << QPointF(point.x, point.degree);
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
      for (const fuzzy::Variable& each : model->inputs()) height += plot_height(each);
      for (const fuzzy::Variable& each : model->outputs()) height += plot_height(each);
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
    painter.setRenderHint(QPainter::Antialiasing);
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
    for (std::size_t i = 0; i < model->inputs().size(); ++i) {
      draw_variable(painter, model->inputs()[i], top, i < now.inputs.size() ? now.inputs[i] : kNone,
                    nullptr, {});
      top += plot_height(model->inputs()[i]);
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
      draw_variable(painter, output, top, given == outputs.end() ? kNone : given->second,
                    is_known ? &now.sets[i] : &kNothing, is_known ? now.centres[i] : std::nullopt);
      top += plot_height(output);
    }
  }

 private:
  static constexpr int kFigure_em = 3;  // "0.25"

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

  /// The names of the terms: each above its peak, a line higher than those that it would cover.
  struct Name {
    QString text;
    QRectF place;  // from the bottom of the lowest line
  };
  std::vector<Name> names_of(const fuzzy::Variable& variable, double left, double right) const {
    std::vector<Name> names;
    const double height = fontMetrics().height();
    const double length = std::max(variable.range.high - variable.range.low, 1e-9);
    for (const fuzzy::Term& term : variable.terms) {
      Name& name = names.emplace_back(Name{QString::fromStdString(term.name), {}});
      const double peak = fuzzy::mean_of_maxima(term.set).value_or(variable.range.low);
      const double width = fontMetrics().horizontalAdvance(name.text);
      const double middle = left + (peak - variable.range.low) / length * (right - left);
      name.place = {std::clamp(middle - width / 2.0, left, std::max(left, right - width)), -height,
                    width + em() / 2.0, height};
      const auto is_covered = [&](const Name& other) {
        return &other != &name && other.place.intersects(name.place);
      };
      while (std::any_of(names.begin(), names.end(), is_covered)) {
        name.place.translate(0.0, -height);
      }
    }
    return names;
  }
  double left_of_axes() const { return 2.7 * em(); }
  double right_of_axes() const { return width() - 2.0 * em(); }
  int names_height(const fuzzy::Variable& variable) const {
    double top = 0.0;
    for (const Name& each : names_of(variable, left_of_axes(), right_of_axes())) {
      top = std::min(top, each.place.top());
    }
    return static_cast<int>(-top);
  }
  /// A title, the names of the terms, and the axes.
  int plot_height(const fuzzy::Variable& variable) const {
    return names_height(variable) + fontMetrics().height() * 10;
  }

  void draw_variable(QPainter& painter, const fuzzy::Variable& variable, int top, double value,
                     const FuzzySet* cut, std::optional<double> centre) const {
    const double line = fontMetrics().height();
    const Axes axes(painter, QRectF(0, top + names_height(variable), width(), 10.0 * line),
                    {variable.range.low, std::max(variable.range.high, variable.range.low + 1e-9)},
                    {0.0, 1.05});
    QString title =
        QStringLiteral("%1 = %2").arg(QString::fromStdString(variable.name), number_text(value));
    for (const fuzzy::Term& term : variable.terms) {
      const double degree = std::round(100 * term.set.degree(value)) / 100;
      if (cut == nullptr && std::isfinite(value) && degree > 0.0) {
        title +=
            QStringLiteral("   %1 %2").arg(QString::fromStdString(term.name), number_text(degree));
      }
    }
    if (centre) {
      title += tr("   centre of gravity %1").arg(number_text(std::round(1000 * *centre) / 1000));
    }
    axes.draw(painter, palette(), {}, {});
    painter.drawText(QRectF(left_of_axes(), top, width() - left_of_axes(), 1.3 * line),
                     Qt::AlignVCenter,
                     fontMetrics().elidedText(title, Qt::ElideRight,
                                              static_cast<int>(width() - left_of_axes())));
    int n = 0;
    const std::vector<Name> names = names_of(variable, left_of_axes(), right_of_axes());
    for (const fuzzy::Term& term : variable.terms) {
      axes.draw_curve(painter, polygon(term.set),
                      QPen(curve_colour(n, palette()), 1.5, pen_style(n)));
      painter.setPen(curve_colour(n, palette()));
      const Name& name = names[static_cast<std::size_t>(n)];
      painter.drawText(name.place.translated(0.0, axes.area().top() - 2.0),
                       Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, name.text);
      ++n;
    }
    const QPen ink(palette().color(QPalette::Text), 2.0);
    if (cut != nullptr && !cut->points.empty()) {
      QPolygonF area;
      area << axes.at(cut->points.front().x, 0.0);
      for (const QPointF& point : polygon(*cut)) {
        area << axes.at(point.x(), point.y());
      }
      area << axes.at(cut->points.back().x, 0.0);
      painter.setPen(ink);
      painter.setBrush(QBrush(palette().color(QPalette::Text), Qt::BDiagPattern));
      painter.drawPolygon(area);
    }
    if (centre) {
      const double half = 0.4 * fontMetrics().height();
      const QPointF at = axes.at(*centre, 0.0);
      painter.setPen(ink);
      painter.setBrush(curve_colour(0, palette()));
      painter.drawPolygon({{at, at + QPointF(-half, 1.7 * half), at + QPointF(half, 1.7 * half)}});
      painter.setBrush(Qt::NoBrush);
    }
    if (std::isfinite(value)) {
      axes.draw_curve(painter, {{QPointF(value, 0.0), QPointF(value, 1.05)}}, ink);
    }
  }
};

FuzzyPanel::FuzzyPanel(QWidget* parent)
    : QWidget(parent), models_(new QComboBox(this)), page_(new Page), surface_(new ControlSurface) {
  setObjectName(QStringLiteral("fuzzy"));
  models_->setObjectName(QStringLiteral("fuzzy_models"));
  models_->setAccessibleName(tr("Fuzzy model"));
  quiet_wheel(models_);
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
  column->addWidget(models_);
  column->addWidget(area);
  connect(models_, &QComboBox::currentIndexChanged, this, &FuzzyPanel::load);
}

FuzzyPanel::~FuzzyPanel() = default;

void FuzzyPanel::set_robot(const QString& id) {
  if (id != robot_) {
    robot_ = id;
    clear();
  }
}

void FuzzyPanel::clear() {
  models_->clear();
  load();
}

void FuzzyPanel::load() {
  surface_->set_model(nullptr);
  page_->model.reset();
  page_->problem.clear();
  page_->inputs.clear();
  page_->outputs.clear();
  const QStringList source = models_->currentData().toStringList();
  if (source.size() == 2) {
    try {
      page_->model = fuzzy::read_fcl(source[0].toStdString(), source[1].toStdString());
    } catch (const std::exception& error) {
      page_->problem = QString::fromUtf8(error.what());
    }
  }
  page_->fit();
  surface_->set_model(page_->model ? &*page_->model : nullptr);
}

void FuzzyPanel::add(const Json& state) {
  std::map<QString, int> times;  // a path may occur several times
  for (const Json& entry : member(robot_of(state, robot_), "fuzzy")) {
    const QString path = text_of(entry, "path");
    const int count = ++times[path];
    const QString name = count == 1 ? path : QStringLiteral("%1 (%2)").arg(path).arg(count);
    const QStringList source{text_of(entry, "file"), text_of(entry, "block")};
    if (const int place = models_->findText(name); place < 0) {
      models_->addItem(name, source);
    } else if (models_->itemData(place).toStringList() != source) {
      models_->setItemData(place, source);
      if (place == models_->currentIndex()) {
        load();
      }
    }
    if (name == models_->currentText()) {
      for (const auto& [key, value] : member(entry, "inputs").items()) {
        page_->inputs[key] = number_of(member(entry, "inputs"), key.c_str());
      }
      for (const auto& [key, value] : member(entry, "outputs").items()) {
        page_->outputs[key] = number_of(member(entry, "outputs"), key.c_str());
      }
    }
  }
  page_->think();
  surface_->set_inputs(page_->now.inputs);
}

const FuzzyInstant& FuzzyPanel::now() const { return page_->now; }
QString FuzzyPanel::problem() const {
  return page_->problem.isEmpty() ? page_->now.problem : page_->problem;
}

}  // namespace elsie::desktop

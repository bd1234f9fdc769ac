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
#include "paint/figures.h"
#include "paint/quiet_wheel.h"
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

  void fit() {
    const auto variables = model ? model->inputs().size() + model->outputs().size() : 0;
    const auto rules = model ? model->rules().size() : 0;
    setMinimumHeight(static_cast<int>(variables) * plot_height() +
                     (static_cast<int>(rules) + 1) * row_height());
    think();
  }

 protected:
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
      top += plot_height();
    }
    const int em = fontMetrics().horizontalAdvance(u'm');
    for (std::size_t i = 0; i < model->rules().size(); ++i, top += row_height()) {
      const double degree = i < now.degrees.size() ? std::clamp(now.degrees[i], 0.0, 1.0) : 0.0;
      const QRectF bar(em / 2.0, top + 2, 4.0 * em, row_height() - 4);
      painter.fillRect(QRectF(bar.topLeft(), QSizeF(bar.width() * degree, bar.height())),
                       curve_colour(0, palette()));
      painter.setPen(palette().color(QPalette::Text));
      painter.drawRect(bar);
      painter.drawText(
          QRect(5 * em, top, width() - 5 * em, row_height()), Qt::AlignVCenter,
          QStringLiteral("%1  %2").arg(number_text(std::round(100 * degree) / 100),
                                       QString::fromStdString(model->rules()[i].text)));
    }
    static const FuzzySet kNothing;
    for (std::size_t i = 0; i < model->outputs().size(); ++i) {
      const auto& output = model->outputs()[i];
      const auto given = outputs.find(output.name);
      const bool is_known = i < now.sets.size();
      draw_variable(painter, output, top, given == outputs.end() ? kNone : given->second,
                    is_known ? &now.sets[i] : &kNothing, is_known ? now.centres[i] : std::nullopt);
      top += plot_height();
    }
  }

 private:
  int plot_height() const { return fontMetrics().height() * 10; }
  int row_height() const { return fontMetrics().height() * 4 / 3; }

  void draw_variable(QPainter& painter, const fuzzy::Variable& variable, int top, double value,
                     const FuzzySet* cut, std::optional<double> centre) const {
    const Axes axes(painter, QRectF(0, top, width(), plot_height()),
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
    axes.draw(painter, palette(), {}, title);
    int n = 0;
    std::vector<QRectF> taken;
    for (const fuzzy::Term& term : variable.terms) {
      axes.draw_curve(painter, polygon(term.set),
                      QPen(curve_colour(n, palette()), 1.5, pen_style(n)));
      if (const auto peak = fuzzy::mean_of_maxima(term.set)) {
        const QString name = QString::fromStdString(term.name);
        const QSizeF size(fontMetrics().horizontalAdvance(name), fontMetrics().height());
        QRectF place(QPointF(axes.at(*peak, 1.0).x() - size.width() / 2.0, axes.area().top()),
                     size);
        place.moveLeft(
            std::clamp(place.left(), axes.area().left(),
                       std::max(axes.area().left(), axes.area().right() - size.width())));
        // Moves the name below those that it would cover.
        while (std::any_of(taken.begin(), taken.end(),
                           [&](const QRectF& other) { return other.intersects(place); })) {
          place.translate(0.0, size.height());
        }
        taken.push_back(place);
        painter.setPen(curve_colour(n, palette()));
        painter.drawText(place, Qt::AlignCenter | Qt::TextDontClip, name);
      }
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

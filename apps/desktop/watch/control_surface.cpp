#include "watch/control_surface.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "paint/axes.h"
#include "paint/boxes.h"
#include "paint/chart.h"

namespace elsie::desktop {
namespace {

constexpr int kBetween_ms = 250;
constexpr int kFewest_em = 16;  // the height, in lines of text

QString name_of(const fuzzy::Variable& variable) { return QString::fromStdString(variable.name); }

}  // namespace

picture::Axis axis_of(const fuzzy::Variable& variable) {
  const fuzzy::Range& range = variable.range;
  return {variable.name, "", range.low,
          std::max(range.high, range.low + 1e-9 * std::max(1.0, std::abs(range.low)))};
}

ControlSurface::ControlSurface(QWidget* parent)
    : QWidget(parent),
      output_(new QComboBox(this)),
      across_(new QComboBox(this)),
      up_(new QComboBox(this)),
      choices_(new QWidget(this)) {
  setObjectName(QStringLiteral("control_surface"));
  setAccessibleName(tr("Control surface"));
  offer_figures(this);
  output_->setObjectName(QStringLiteral("surface_output"));
  output_->setAccessibleName(tr("Output"));
  across_->setObjectName(QStringLiteral("surface_across"));
  across_->setAccessibleName(tr("Input across"));
  up_->setObjectName(QStringLiteral("surface_up"));
  up_->setAccessibleName(tr("Input upwards"));
  auto* row = new QHBoxLayout(choices_);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(output_, 1);
  row->addWidget(new QLabel(tr("over"), choices_));
  row->addWidget(across_, 1);
  and_ = new QLabel(tr("and"), choices_);
  row->addWidget(and_);
  row->addWidget(up_, 1);
  auto* column = new QVBoxLayout(this);
  column->addWidget(choices_);
  column->addStretch();
  setMinimumHeight(choices_->sizeHint().height() + kFewest_em * fontMetrics().height());
  later_.setSingleShot(true);
  later_.setInterval(kBetween_ms);
  connect(&later_, &QTimer::timeout, this, &ControlSurface::compute);
  for (QComboBox* each : {output_, across_, up_}) {
    quiet_wheel(each);
    each->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    each->setMinimumContentsLength(2);
    each->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // a dock may be narrow
    connect(each, &QComboBox::activated, this, &ControlSurface::choose);
  }
  hide();
}

void ControlSurface::set_model(const fuzzy::Model* model) {
  later_.stop();
  model_ = model && !model->inputs().empty() && !model->outputs().empty() ? model : nullptr;
  inputs_.clear();
  for (QComboBox* each : {output_, across_, up_}) {
    each->clear();
  }
  setVisible(model_ != nullptr);
  if (!model_) {
    return;
  }
  for (const auto& output : model_->outputs()) {
    output_->addItem(name_of(output));
  }
  for (const fuzzy::Variable& input : model_->inputs()) {
    across_->addItem(name_of(input));
    up_->addItem(name_of(input));
  }
  const bool has_two = model_->inputs().size() > 1;
  up_->setVisible(has_two);
  and_->setVisible(has_two);
  up_->setCurrentIndex(has_two ? 1 : 0);
  compute();
}

void ControlSurface::set_inputs(const std::vector<double>& inputs) {
  inputs_ = inputs;
  if (model_ && held() != computed_for_ && !later_.isActive()) {
    later_.start();
  }
  update();
}

/// The output's range, with the values of formulas beyond it.
picture::Axis ControlSurface::output_axis() const {
  const fuzzy::Variable& output =
      model_->outputs()[static_cast<std::size_t>(output_->currentIndex())];
  picture::Axis axis = axis_of(output);
  for (const double value : grid_.values) {
    if (std::isfinite(value)) {
      axis.low = std::min(*axis.low, value);
      axis.high = std::max(*axis.high, value);
    }
  }
  return axis;
}

// Keeps the two inputs different: the input that was not just chosen changes.
void ControlSurface::choose() {
  if (model_->inputs().size() > 1 && across_->currentIndex() == up_->currentIndex()) {
    QComboBox* other = sender() == across_ ? up_ : across_;
    other->setCurrentIndex((other->currentIndex() + 1) % other->count());
  }
  compute();
}

std::vector<double> ControlSurface::held() const {
  std::vector<double> all;
  for (std::size_t i = 0; i < model_->inputs().size(); ++i) {
    const fuzzy::Range& range = model_->inputs()[i].range;
    const bool is_shown = static_cast<int>(i) == across_->currentIndex() ||
                          static_cast<int>(i) == up_->currentIndex();
    all.push_back(!is_shown && i < inputs_.size() ? inputs_[i] : 0.5 * (range.low + range.high));
  }
  return all;
}

void ControlSurface::compute() {
  if (!model_) {
    return;
  }
  computed_for_ = held();
  const bool has_two = model_->inputs().size() > 1;
  grid_ = fuzzy_grid(
      *model_, static_cast<std::size_t>(output_->currentIndex()),
      static_cast<std::size_t>(across_->currentIndex()),
      has_two ? std::optional(static_cast<std::size_t>(up_->currentIndex())) : std::nullopt,
      computed_for_);
  update();
}

Figures ControlSurface::figures() const {
  Figures figures;
  if (!model_) {
    return figures;
  }
  constexpr std::size_t kEvery = 5;
  const auto at = [this](const QComboBox* input, std::size_t place, std::size_t count) {
    const fuzzy::Range& range =
        model_->inputs()[static_cast<std::size_t>(input->currentIndex())].range;
    return number_text(range.low + (range.high - range.low) * static_cast<double>(place) /
                                       static_cast<double>(std::max<std::size_t>(1, count - 1)));
  };
  const bool has_two = grid_.rows > 1;
  figures.columns << (has_two ? up_->currentText() + " \\ " + across_->currentText()
                              : output_->currentText());
  for (std::size_t i = 0; i < FuzzyGrid::kAcross; i += kEvery) {
    figures.columns << at(across_, i, FuzzyGrid::kAcross);
  }
  for (std::size_t row = 0; row < grid_.rows; row += kEvery) {
    QStringList cells{has_two ? at(up_, row, grid_.rows) : output_->currentText()};
    for (std::size_t i = 0; i < FuzzyGrid::kAcross; i += kEvery) {
      cells << number_text(grid_.values[row * FuzzyGrid::kAcross + i]);
    }
    figures.rows.push_back(cells);
  }
  return figures;
}

void ControlSurface::paintEvent(QPaintEvent*) {
  if (!model_) {
    return;
  }
  QPainter painter(this);
  const QRectF whole(0, choices_->geometry().bottom(), width(),
                     height() - choices_->geometry().bottom());
  draw_chart(painter, whole, grid_.rows > 1 ? picture::Panel(map()) : picture::Panel(curve()),
             palette());
}

picture::HeatMap ControlSurface::map() const {
  const auto across = static_cast<std::size_t>(across_->currentIndex());
  const auto up = static_cast<std::size_t>(up_->currentIndex());
  picture::HeatMap map;
  map.field = {axis_of(model_->inputs()[across]),
               axis_of(model_->inputs()[up]),
               output_axis(),
               FuzzyGrid::kAcross,
               grid_.rows,
               grid_.values};
  if (inputs_.size() == model_->inputs().size() && std::isfinite(inputs_[across]) &&
      std::isfinite(inputs_[up])) {
    map.mark = {inputs_[across], inputs_[up]};
  }
  return map;
}

picture::LineChart ControlSurface::curve() const {
  const fuzzy::Variable& input = model_->inputs().front();
  picture::LineChart chart{"", axis_of(input), output_axis(), {}, picture::Naming::at_peak};
  auto& points = chart.series.emplace_back().points;
  for (std::size_t i = 0; i < grid_.values.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(FuzzyGrid::kAcross - 1);
    points.push_back(
        {input.range.low + share * (input.range.high - input.range.low), grid_.values[i]});
  }
  if (!inputs_.empty()) {
    picture::Series& now = chart.series.emplace_back();
    now.colour = picture::kNeutral;
    now.points = {{inputs_.front(), *chart.y.low}, {inputs_.front(), *chart.y.high}};
  }
  return chart;
}

}  // namespace elsie::desktop

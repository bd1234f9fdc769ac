#include "watch/control_surface.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "paint/boxes.h"

namespace elsie::desktop {
namespace {

constexpr int kBetween_ms = 250;
constexpr int kFewest_em = 16;  // the height, in lines of text

/// From low to high: lighter is more, as in grey.
QColor colour_at(double share) {
  static constexpr std::array<std::array<double, 3>, 5> kStops{
      {{0, 34, 78}, {65, 77, 107}, {124, 123, 120}, {188, 175, 111}, {253, 234, 69}}};
  const double at = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const double rest = at - static_cast<double>(below);
  const auto mixed = [&](std::size_t i) {
    return static_cast<int>(
        std::lround((1.0 - rest) * kStops[below][i] + rest * kStops[below + 1][i]));
  };
  return {mixed(0), mixed(1), mixed(2)};
}

Span span_of(const fuzzy::Range& range) {
  return {range.low, std::max(range.high, range.low + 1e-9)};
}

QString name_of(const fuzzy::Variable& variable) { return QString::fromStdString(variable.name); }

}  // namespace

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
  const fuzzy::Range& range =
      model_->outputs()[static_cast<std::size_t>(output_->currentIndex())].range;
  values_ = {range.high, range.low};
  for (const double value : grid_.values) {
    if (std::isfinite(value)) {
      values_ = {std::min(values_.low, value), std::max(values_.high, value)};
    }
  }
  if (!(values_.length() > 0.0)) {
    values_ = span_of(range);
  }
  const int across = static_cast<int>(FuzzyGrid::kAcross);
  field_ = QImage(across, static_cast<int>(grid_.rows), QImage::Format_ARGB32_Premultiplied);
  field_.fill(Qt::transparent);
  for (std::size_t i = 0; i < grid_.values.size(); ++i) {
    const int place = static_cast<int>(i);
    if (std::isfinite(grid_.values[i])) {
      field_.setPixelColor(place % across, field_.height() - 1 - place / across,
                           colour_at((grid_.values[i] - values_.low) / values_.length()));
    }
  }
  update();
}

Figures ControlSurface::figures() const {
  Figures figures;
  if (!model_) {
    return figures;
  }
  constexpr std::size_t kEvery = 5;
  const auto at = [](const Span& span, std::size_t place, std::size_t count) {
    return number_text(span.low + span.length() * static_cast<double>(place) /
                                      static_cast<double>(std::max<std::size_t>(1, count - 1)));
  };
  const Span x = span_of(model_->inputs()[static_cast<std::size_t>(across_->currentIndex())].range);
  const bool has_two = grid_.rows > 1;
  figures.columns << (has_two ? up_->currentText() + " \\ " + across_->currentText()
                              : output_->currentText());
  for (std::size_t i = 0; i < FuzzyGrid::kAcross; i += kEvery) {
    figures.columns << at(x, i, FuzzyGrid::kAcross);
  }
  for (std::size_t row = 0; row < grid_.rows; row += kEvery) {
    QStringList cells{
        has_two ? at(span_of(model_->inputs()[static_cast<std::size_t>(up_->currentIndex())].range),
                     row, grid_.rows)
                : output_->currentText()};
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
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QRectF whole(0, choices_->geometry().bottom(), width(),
                     height() - choices_->geometry().bottom());
  grid_.rows > 1 ? draw_field(painter, whole) : draw_curve(painter, whole);
}

void ControlSurface::draw_field(QPainter& painter, const QRectF& whole) const {
  const double line = painter.fontMetrics().height();
  const auto across = static_cast<std::size_t>(across_->currentIndex());
  const auto up = static_cast<std::size_t>(up_->currentIndex());
  const Axes axes(painter, whole.adjusted(0, 0, -scale_width(), 0),
                  span_of(model_->inputs()[across].range), span_of(model_->inputs()[up].range));
  painter.drawImage(axes.area(), field_);
  axes.draw(painter, palette(), across_->currentText(),
            fontMetrics().elidedText(up_->currentText(), Qt::ElideMiddle,
                                     static_cast<int>(axes.area().width() / 2.0 - line)));
  draw_scale(painter, axes.area());
  if (inputs_.size() == model_->inputs().size()) {
    painter.setPen(QPen(Qt::white, 3.0));
    painter.setBrush(Qt::black);
    const QRectF& area = axes.area();
    QPointF at = axes.at(inputs_[across], inputs_[up]);
    at = {std::clamp(at.x(), area.left(), area.right()),
          std::clamp(at.y(), area.top(), area.bottom())};
    painter.drawEllipse(at, 0.35 * line, 0.35 * line);
  }
}

/// Of the bar of colours with its numbers.
double ControlSurface::scale_width() const {
  const QFontMetricsF font = fontMetrics();
  double widest = 0.0;
  for (const double tick : ticks(values_, 5)) {
    widest = std::max(widest, font.horizontalAdvance(number_text(tick)));
  }
  return 1.5 * font.height() + widest;
}

void ControlSurface::draw_scale(QPainter& painter, const QRectF& area) const {
  const double line = painter.fontMetrics().height();
  const QRectF bar(area.right() + line, area.top(), line, area.height());
  QLinearGradient colours(bar.bottomLeft(), bar.topLeft());
  for (int i = 0; i <= 8; ++i) {
    colours.setColorAt(i / 8.0, colour_at(i / 8.0));
  }
  painter.setPen(palette().color(QPalette::Text));
  painter.setBrush(colours);
  painter.drawRect(bar);
  for (const double tick : ticks(values_, 5)) {
    const double y = bar.bottom() - (tick - values_.low) / values_.length() * bar.height();
    painter.drawText(QRectF(bar.right() + 0.3 * line, y - line, scale_width(), 2.0 * line),
                     Qt::AlignLeft | Qt::AlignVCenter, number_text(tick));
  }
  const double right = width() - 0.3 * line;  // its name ends there, over the bar
  const QRectF title(area.center().x(), bar.top() - 1.4 * line, right - area.center().x(),
                     1.2 * line);
  painter.drawText(title, Qt::AlignRight | Qt::AlignVCenter,
                   fontMetrics().elidedText(output_->currentText(), Qt::ElideMiddle,
                                            static_cast<int>(title.width())));
}

void ControlSurface::draw_curve(QPainter& painter, const QRectF& whole) const {
  const Span x = span_of(model_->inputs().front().range);
  const Axes axes(painter, whole, x, values_);
  axes.draw(painter, palette(), across_->currentText(), output_->currentText());
  QPolygonF curve;
  for (std::size_t i = 0; i < grid_.values.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(FuzzyGrid::kAcross - 1);
    curve << QPointF(x.low + share * x.length(), grid_.values[i]);
  }
  axes.draw_curve(painter, curve, QPen(curve_colour(0, palette()), 2.0));
  if (!inputs_.empty()) {
    const QPen ink(palette().color(QPalette::Text), 1.5, Qt::DashLine);
    axes.draw_curve(
        painter, {{QPointF(inputs_.front(), values_.low), QPointF(inputs_.front(), values_.high)}},
        ink);
  }
}

}  // namespace elsie::desktop

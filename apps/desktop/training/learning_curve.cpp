#include "training/learning_curve.h"

#include <QPainter>
#include <algorithm>

#include "paint/axes.h"
#include "paint/chart.h"

namespace elsie::desktop {
namespace {

constexpr double kLeastError = 1e-12;  // an error of 0 has no logarithm

}  // namespace

LearningCurve::LearningCurve(QWidget* parent) : QWidget(parent) {
  setObjectName("learning_curve");
  setAccessibleName(tr("Learning curve"));
  offer_figures(this);
  setMinimumSize(12 * fontMetrics().height(), 8 * fontMetrics().height());
}

Figures LearningCurve::figures() const {
  Figures figures{{tr("samples presented"), tr("mean error")}, {}};
  for (const QPointF& point : points_) {
    figures.rows.push_back({number_text(point.x()), number_text(point.y())});
  }
  return figures;
}

QSize LearningCurve::sizeHint() const { return minimumSize() * 2; }

void LearningCurve::clear() {
  points_.clear();
  update();
}

void LearningCurve::add(double presentations, double most, double error) {
  most_ = most;
  points_ << QPointF(presentations, error);
  update();
}

void LearningCurve::show_all(const QPolygonF& points, double most) {
  points_ = points;
  most_ = most;
  update();
}

void LearningCurve::paintEvent(QPaintEvent* /*event*/) {
  picture::LineChart chart;
  chart.x = {tr("samples presented").toStdString(), "", 0.0, std::max(1.0, most_)};
  chart.y = {tr("mean error").toStdString(), "", {}, {}, true};
  auto& points = chart.series.emplace_back().points;
  for (const QPointF& point : points_) {
    points.push_back({point.x(), std::max(point.y(), kLeastError)});
  }
  QPainter painter(this);
  if (points_.isEmpty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("The training draws its learning curve here"));
    return;
  }
  draw_chart(painter, rect(), chart, palette());
}

}  // namespace elsie::desktop

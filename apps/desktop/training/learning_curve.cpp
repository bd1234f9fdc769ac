#include "training/learning_curve.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "paint/axes.h"

namespace elsie::desktop {
namespace {

constexpr double kLeastError = 1e-12;  // an error of 0 has no logarithm

double exponent(double error) { return std::log10(std::max(error, kLeastError)); }

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
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().base());
  Span errors{-1.0, 0.0};
  QPolygonF curve;
  for (const QPointF& point : points_) {
    curve << QPointF(point.x(), exponent(point.y()));
    errors.low = std::min(errors.low, std::floor(curve.back().y()));
    errors.high = std::max(errors.high, std::ceil(curve.back().y()));
  }
  const Axes axes(painter, rect(), {0.0, most_}, errors);
  axes.draw(painter, palette(), tr("samples presented"), tr("mean error, as a power of ten"));
  axes.draw_curve(painter, curve, QPen(curve_colour(0, palette()), 2.0));
}

}  // namespace elsie::desktop

// The mean error of a network over the samples that were presented to it.
#pragma once

#include <QPolygonF>
#include <QWidget>

#include "paint/figures.h"

namespace elsie::desktop {

class LearningCurve : public QWidget, public ShowsFigures {
  Q_OBJECT

 public:
  explicit LearningCurve(QWidget* parent = nullptr);

  void clear();
  /// Adds the mean error after so many presentations of `most`; the axis is logarithmic.
  void add(double presentations, double most, double error);
  /// Shows the whole curve instead of the points so far.
  void show_all(const QPolygonF& points, double most);
  /// Presentations and errors.
  const QPolygonF& points() const { return points_; }

  Figures figures() const override;
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QPolygonF points_;
  double most_ = 1.0;
};

}  // namespace elsie::desktop

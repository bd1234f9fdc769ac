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
  /// The mean error after so many presentations of `most`; drawn on a logarithmic axis.
  void add(double presentations, double most, double error);
  /// The whole curve instead of the points so far.
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

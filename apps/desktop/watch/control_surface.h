// The control surface of a fuzzy model, with a mark at the present inputs.
#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>
#include <vector>

#include "elsie/fuzzy/model.h"

#include "paint/axes.h"
#include "paint/figures.h"
#include "watch/fuzzy_instant.h"

class QComboBox;
class QLabel;

namespace elsie::desktop {

/// Shows one output over two inputs that the user chooses, as colours with a scale; with only one
/// input, as a curve. The other inputs have their present values, or the middle of their ranges.
class ControlSurface : public QWidget, public ShowsFigures {
  Q_OBJECT

 public:
  explicit ControlSurface(QWidget* parent = nullptr);

  /// Null shows no model. The model must live until the next call.
  void set_model(const fuzzy::Model* model);
  void set_inputs(const std::vector<double>& inputs);

  const FuzzyGrid& grid() const { return grid_; }
  /// The values at every fifth point across and up.
  Figures figures() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void choose();
  void compute();
  std::vector<double> held() const;
  void draw_field(QPainter& painter, const QRectF& whole) const;
  void draw_curve(QPainter& painter, const QRectF& whole) const;
  double scale_width() const;
  void draw_scale(QPainter& painter, const QRectF& area) const;

  const fuzzy::Model* model_ = nullptr;
  std::vector<double> inputs_;
  QComboBox* output_;
  QComboBox* across_;
  QComboBox* up_;
  QLabel* and_;
  QWidget* choices_;
  QTimer later_;
  std::vector<double> computed_for_;  // the values of the held inputs
  FuzzyGrid grid_;
  Span values_;  // in the grid
  QImage field_;
};

}  // namespace elsie::desktop

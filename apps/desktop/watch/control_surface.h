// The control surface of a fuzzy model, with a mark at the present inputs.
#pragma once

#include <QTimer>
#include <QWidget>
#include <vector>

#include "elsie/fuzzy/model.h"
#include "elsie/picture/plot.h"

#include "paint/figures.h"
#include "watch/fuzzy_instant.h"

class QComboBox;
class QLabel;

namespace elsie::desktop {

/// The variable's range, which is not empty then.
picture::Axis axis_of(const fuzzy::Variable& variable);

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
  picture::Axis output_axis() const;
  picture::HeatMap map() const;
  picture::LineChart curve() const;

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
};

}  // namespace elsie::desktop

// Which behaviour decides what a robot does, now and over the last seconds.
#pragma once

#include <QAbstractScrollArea>
#include <deque>
#include <memory>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "paint/figures.h"

namespace elsie::desktop {

/// A row for each behaviour of a robot, indented by its depth: a band over time as high as its
/// share (grey where it was not asked), a bar of its activation, its priority, share and command,
/// and the reason of this instant.
class CoordinationPanel : public QAbstractScrollArea, public ShowsFigures {
  Q_OBJECT

 public:
  explicit CoordinationPanel(QWidget* parent = nullptr);
  ~CoordinationPanel() override;

  /// Shows this robot from the next state on; the bands of the previous robot are removed.
  void set_robot(const QString& id);
  const QString& robot() const { return robot_; }
  /// Takes a `state` event. The bands start again if its time is before the last one, or its epoch
  /// is another one.
  void add(const nlohmann::ordered_json& state);
  void clear();

  Figures figures() const override;
  int rows() const;
  /// Everything about a row except its band, for tool tips and screen readers.
  QString row_text(int row) const;
  /// The share in [0, 1] of the row at the last instant not after time_s; NaN if it was not asked,
  /// or if nothing is known.
  double share_at(int row, double time_s) const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool viewportEvent(QEvent* event) override;

 private:
  struct Row;
  struct Instant {
    double time_s;
    std::vector<float> shares;  // NaN: not asked
  };

  int row_height() const;
  void lay_out();

  QString robot_;
  std::vector<Row> rows_;
  std::deque<Instant> past_;
};

}  // namespace elsie::desktop

// Which behaviour decides what a robot does, now and over the last seconds.
#pragma once

#include <QAbstractScrollArea>
#include <QStringList>
#include <optional>
#include <vector>

#include "engine/past.h"
#include "paint/figures.h"

class QPainter;

namespace elsie::desktop {

/// A row for each behaviour of a robot, indented by its depth: a band over the last seconds as high
/// as its share (grey where it was not asked), a bar of its activation, the weight that its
/// coordinator gives it, its share and command, and the reason of this instant. While the window
/// looks back, all are those of the shown time, as far as they are stored: not the reason.
class CoordinationPanel : public QAbstractScrollArea, public ShowsFigures {
  Q_OBJECT

 public:
  explicit CoordinationPanel(QWidget* parent = nullptr);
  ~CoordinationPanel() override;

  /// Shows this robot from the next state on.
  void set_robot(const QString& id);
  const QString& robot() const { return robot_; }
  /// The stored numbers(), which must outlive the panel. Call it again when they have changed.
  void set_samples(const Samples& samples);
  /// Takes a `state` event: the rows of the present.
  void add(const Json& state);
  /// Shows the rows of that time, s; none: those of the present.
  void look_back(std::optional<double> time_s);
  void clear();
  /// The stored numbers that the panel needs: those of the bands or, to look back, of all columns.
  QStringList numbers(bool looks_back) const;

  Figures figures() const override;
  int rows() const;
  /// Everything about a row except its band, for tool tips and screen readers.
  QString row_text(int row) const;
  /// The share in [0, 1] of the row at the last sample not after time_s; NaN if it was not asked,
  /// or if nothing is known.
  double share_at(int row, double time_s) const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool viewportEvent(QEvent* event) override;

 private:
  struct Row;

  /// The stored number of a row, such as "share", by its whole name.
  QString number_of_row(const Row& row, const char* name) const;
  /// The rows of the shown time.
  std::vector<Row> shown_rows() const;
  static void set_percents(std::vector<Row>& rows);
  void paint_band(QPainter& painter, const QRectF& lane, int row, double start_s,
                  double end_s) const;
  int row_height() const;
  void lay_out();

  QString robot_;
  std::vector<Row> rows_;  // of the present
  const Samples* samples_ = nullptr;
  double now_s_ = 0.0;  // of the rows
  std::optional<double> looked_back_to_s_;
};

}  // namespace elsie::desktop

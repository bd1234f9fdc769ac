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
/// looks back, all are those of the shown time, at which the bands have a line; the reason is that
/// of the look, if one is stored. A press or a drag in the bands wishes to see that time.
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
  /// The reasons of that time, which follow it; null: they are not known.
  void set_look(const Instant* then);
  /// The place of a time in the bands, px from the left; none if they do not show it.
  std::optional<double> place_of(double time_s) const;
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

 Q_SIGNALS:
  void time_wished(double time_s);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool viewportEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  struct Row;

  /// The stored number of a row, such as "share", by its whole name.
  QString number_of_row(const Row& row, const char* name) const;
  /// The rows of the shown time.
  std::vector<Row> shown_rows() const;
  QString reason_then(const QString& path) const;
  static void set_percents(std::vector<Row>& rows);
  void paint_band(QPainter& painter, const QRectF& lane, int row, double start_s,
                  double end_s) const;
  int row_height() const;
  void lay_out();
  /// Where the bands are, and the times that they show.
  struct Bands {
    int left = 0, width = 0;  // px
    double start_s = 0.0, length_s = 1.0;

    double x_of(double time_s) const { return left + (time_s - start_s) / length_s * width; }
    double time_at(double x) const { return start_s + (x - left) / width * length_s; }
  };
  Bands bands() const;
  double latest_s() const;
  int names_width() const;
  int figures_width() const;
  void paint_cursor(QPainter& painter, const Bands& bands, int axis) const;

  QString robot_;
  std::vector<Row> rows_;  // of the present
  const Samples* samples_ = nullptr;
  double now_s_ = 0.0;  // of the rows
  std::optional<double> looked_back_to_s_;
  double start_s_ = 0.0;  // of the bands while the window looks back
  std::optional<Instant> then_;
  bool is_dragged_ = false;
};

}  // namespace elsie::desktop

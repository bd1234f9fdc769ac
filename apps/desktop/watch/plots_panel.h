// Live plots of any number of a run.
#pragma once

#include <QPointF>
#include <QWidget>
#include <deque>
#include <map>

#include <nlohmann/json_fwd.hpp>

class QPainter;
class QTreeWidget;
class QTreeWidgetItem;

namespace elsie::desktop {

/// All numbers of the `state` events in a tree with check boxes, the chosen ones as curves over the
/// simulated time. The last samples of every number are kept, hence a curve that is chosen late has
/// its past.
class PlotsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PlotsPanel(QWidget* parent = nullptr);

  /// Takes a `state` event. A time before the last one, or another epoch, starts again.
  void add(const nlohmann::ordered_json& state);
  void clear();

  /// The numbers known, such as "r1/speed" or "r1/explore/avoid/share", sorted.
  QStringList names() const;
  QStringList chosen() const;
  void choose(const QString& name, bool on);
  /// Draws axes, curves and legend, as on the screen.
  void draw(QPainter& painter, const QRectF& area) const;
  /// Writes the chosen curves by the file's ending: .png or .csv. False: not written.
  bool save(const QString& file) const;

 private:
  using Curve = std::deque<QPointF>;

  void collect(const nlohmann::ordered_json& value, const QString& path, double time);
  void record(const QString& path, const nlohmann::ordered_json& value, double time);
  QTreeWidgetItem* item_of(const QString& name) const;
  void add_item(const QString& name);

  std::map<QString, Curve> curves_;
  std::map<QString, QTreeWidgetItem*> items_;
  double time_ = -1.0;
  long long epoch_ = -1;
  QTreeWidget* tree_;
  QWidget* plot_;
};

}  // namespace elsie::desktop

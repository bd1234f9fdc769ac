// Live plots of any number of a run.
#pragma once

#include <QPointF>
#include <QWidget>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "paint/axes.h"
#include "paint/figures.h"

class QPainter;
class QTreeWidget;
class QTreeWidgetItem;

namespace elsie::picture {
struct LineChart;
}

namespace elsie::desktop {

/// Lists all numbers of the `state` events in a tree with check boxes, and plots the chosen ones
/// over simulated time. The last samples of every number are kept, so that a curve that is chosen
/// late has its past.
class PlotsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PlotsPanel(QWidget* parent = nullptr);

  /// Takes a `state` event. If its time is before the last one, the curves start again.
  void add(const nlohmann::ordered_json& state);
  /// Starts the curves again; the choice stays.
  void begin();
  /// Forgets all numbers, because the world is another one. The choice stays, for numbers of the
  /// same names.
  void clear();

  /// The numbers known, such as "r1/speed" or "r1/explore/avoid/share", sorted.
  QStringList names() const;
  QStringList chosen() const;
  /// The chosen numbers, including numbers that are not known yet; for the next start.
  QStringList choice() const { return {chosen_.begin(), chosen_.end()}; }
  void set_choice(const QStringList& names);
  /// The robots of the chosen numbers, including numbers that are not known yet.
  QStringList chosen_robots() const;
  void choose(const QString& name, bool on);
  /// The chosen numbers: their present values, and the least and greatest values.
  Figures figures() const;
  /// Draws axes, curves and legend, as on the screen: a strip for each unit.
  void draw(QPainter& painter, const QRectF& area) const;
  /// How far apart the samples are; a fast run sends fewer of them.
  QString sampling() const;
  /// Writes the chosen curves in the format of the file's ending: .png, .svg or .csv. Returns "",
  /// or why they were not written.
  QString save(const QString& file) const;

 Q_SIGNALS:
  void choice_changed();

 private:
  using Curve = std::deque<QPointF>;

  void collect(const nlohmann::ordered_json& value, const QString& path, double time);
  void record(const QString& path, const nlohmann::ordered_json& value, double time);
  QTreeWidgetItem* item_of(const QString& name) const;
  void add_item(const QString& name);
  /// The chosen numbers that share an axis.
  struct Strip {
    QString title;  // the unit, or what it is of those without
    QStringList names;
  };
  std::vector<Strip> strips() const;
  void fit();
  void draw_strip(QPainter& painter, const QRectF& area, double legend, const Strip& strip,
                  const Span& x, int& n) const;
  picture::LineChart chart(const Strip& strip) const;
  std::string table() const;

  std::set<QString> chosen_;
  std::map<QString, Curve> curves_;
  std::map<QString, QTreeWidgetItem*> items_;
  double time_ = -1.0;
  QTreeWidget* tree_;
  QWidget* plot_;
};

}  // namespace elsie::desktop

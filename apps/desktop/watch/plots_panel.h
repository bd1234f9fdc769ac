// Live plots of any number of a run.
#pragma once

#include <QHash>
#include <QWidget>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/past.h"
#include "paint/axes.h"
#include "paint/figures.h"

class QPainter;
class QTreeWidget;
class QTreeWidgetItem;

namespace elsie::picture {
struct LineChart;
}

namespace elsie::desktop {

/// Lists all numbers of a run in a tree with check boxes, and plots the chosen ones over simulated
/// time, through the samples that the engine stored from the beginning of the run. While the window
/// looks back, a line marks the shown time, and the legend has the values there. A press or a drag
/// in a plot wishes to see that time.
class PlotsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PlotsPanel(QWidget* parent = nullptr);

  /// The samples of the chosen numbers, which must outlive the panel. Call it again when they have
  /// changed.
  void set_samples(const Samples& samples);
  /// Marks that time, s; none: no time.
  void look_back(std::optional<double> time_s);
  /// The place of a time in the first strip of a plot of this size, px from its left.
  std::optional<double> place_of(double time_s, const QSizeF& size) const;
  /// The time at a place in a plot of this size; none beside the axes.
  std::optional<double> time_at(const QPointF& place, const QSizeF& size) const;
  /// The numbers that exist, and the units of those that have one. The choice stays, for numbers of
  /// the same names.
  void set_names(const QStringList& names, const QHash<QString, QString>& units = {});

  /// The numbers known, such as "r1/speed" or "r1/explore/avoid/share", sorted.
  QStringList names() const;
  QStringList chosen() const;
  /// The chosen numbers, including numbers that are not known yet; for the next start.
  QStringList choice() const { return {chosen_.begin(), chosen_.end()}; }
  void set_choice(const QStringList& names);
  /// The robots of the chosen numbers, including numbers that are not known yet.
  QStringList chosen_robots() const;
  void choose(const QString& name, bool on);
  /// The chosen numbers: their values at the shown time, and the least and greatest values.
  Figures figures() const;
  /// Draws axes, curves and legend, as on the screen: a strip for each unit.
  void draw(QPainter& painter, const QRectF& area) const;
  /// The samples of a number as points, those without a value not finite; where several share a
  /// column of pixels, the first, the last, the least and the greatest of them. `width` of the span
  /// `x` is in px.
  QPolygonF polygon(const QString& name, const Span& x, double width) const;
  /// How far apart the samples are; a long run keeps fewer of them.
  QString sampling() const;
  /// Writes the chosen curves in the format of the file's ending: .png, .svg or .csv. Returns "",
  /// or why they were not written.
  QString save(const QString& file) const;

 Q_SIGNALS:
  void choice_changed();
  void time_wished(double time_s);

 private:
  /// Calls `see` with the time and the value of each sample of a number that has one.
  template <class See>
  void visit(const QString& name, const See& see) const;
  void add_item(const QString& name);
  /// "r1/speed [m/s]"
  QString title_of(const QString& name) const;
  /// The chosen numbers that share an axis.
  struct Strip {
    QString title;  // the unit, or what it is of those without
    QStringList names;
  };
  std::vector<Strip> strips() const;
  void fit();
  /// A chart for each strip, `width` px wide, all over the same time.
  std::vector<picture::LineChart> charts(double width) const;
  void paint_cursor(QPainter& painter, const QRectF& strip, const picture::LineChart& chart) const;
  /// The value of a number at the shown time of the past, for its legend; "" in the present.
  QString value_then(const QString& name) const;
  std::string table() const;

  std::set<QString> chosen_;
  std::set<QString> names_;
  QHash<QString, QString> units_;
  const Samples* samples_ = nullptr;
  std::optional<double> looked_back_to_s_;
  std::map<QString, QTreeWidgetItem*> items_;
  QTreeWidget* tree_;
  QWidget* plot_;
};

}  // namespace elsie::desktop

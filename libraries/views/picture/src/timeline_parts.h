// The parts of a timeline; timeline.h says what they show.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "elsie/picture/timeline.h"
#include "elsie/traces/graph_account.h"

#include "canvas.h"
#include "panel.h"
#include "timeline_columns.h"

namespace elsie::picture {

/// Colours of behaviours: equal for equal paths on all robots; inner behaviours have shades of the
/// outer one's colour.
class BehaviorInks {
 public:
  explicit BehaviorInks(const traces::Trace& trace);
  Ink of(const traces::TraceRobot& robot, int member) const;
  /// The member's colour; grey for several deciders, white for none.
  Ink of_decider(const traces::TraceRobot& robot, traces::Decider decider) const;
  const std::map<std::string, Ink>& by_path() const { return by_path_; }

 private:
  std::map<std::string, Ink> by_path_;
};

/// Symbols of events: a different one for each name, while there are enough.
class EventSymbols {
 public:
  EventSymbols(const traces::Trace& trace, const std::vector<std::size_t>& robots,
               const traces::TimeSpan& span);
  const std::vector<std::string>& names() const { return names_; }
  void draw(Canvas& canvas, const std::string& name, const Vector2& at) const;
  /// Draws a white outline around the symbol, which separates it from earlier ones.
  void draw_rim(Canvas& canvas, const std::string& name, const Vector2& at) const;

 private:
  std::size_t place_of(const std::string& name) const;

  std::vector<std::string> names_;
};

/// The events of one name in a span of time.
struct EventKind {
  std::string name;
  std::vector<double> times_s;  // ascending
};

/// The events of a robot, ordered by the first of each kind.
std::vector<EventKind> event_kinds(const traces::TraceRobot& robot, const traces::TimeSpan& span);

/// The most kinds of events that get a row each. More rows would take too much room.
inline constexpr std::size_t kMostEventRows = 8;

/// Names and numbers left of a plot: their distance and style.
inline constexpr double kBesidePlot = 10.0;
inline const TextStyle kBeside{
    .size = kTick, .ink = kFaintText, .across = Across::right, .down = Down::middle};

/// The least distance between a behaviour's name and its priority, units.
inline constexpr double kNameToPriority = 12.0;

/// Lanes are paler than other panels, so that lines on them are visible.
inline constexpr double kLaneAlpha = 0.55;

/// Shared by all panels of a robot.
struct TimelineBlock {
  const traces::TraceRobot& robot;
  const BehaviorInks& inks;
  traces::TimeSpan span;
  std::vector<Column> columns;
  double left = 0.0;          // of all plots
  double column_width = 0.0;  // in units

  double width() const { return column_width * static_cast<double>(columns.size()); }
  double right() const { return left + width(); }
  double x_of(double time_s) const {
    return left + width() * (time_s - span.from_s) / (span.to_s - span.from_s);
  }
  double x_of_column(std::size_t i) const { return left + column_width * static_cast<double>(i); }
};

/// Vertical lines at the ticks of the times.
void draw_time_grid(Canvas& canvas, const TimelineBlock& block, const Rect& area);
/// Tick labels and name of the time axis, below `y`.
void draw_time_axis(Canvas& canvas, const TimelineBlock& block, double y);

/// Draws the events around the line `y` or, when `in_rows`, in a row for each kind, `row` apart,
/// with its name and count. In a single row, rare events are drawn over frequent ones. Lines go
/// down to `bottom`, those of the rarest kinds first, up to a limit.
void draw_events(Canvas& canvas, const TimelineBlock& block, const std::vector<EventKind>& kinds,
                 const EventSymbols& symbols, bool in_rows, double y, double row, double bottom);
void draw_deciders(Canvas& canvas, const TimelineBlock& block, const Rect& area);
void draw_shares(Canvas& canvas, const TimelineBlock& block, const Rect& area);
void draw_weights(Canvas& canvas, const TimelineBlock& block, const Rect& area);
/// `mean_share`: the member's mean share in the robot's command over the whole span.
void draw_lane(Canvas& canvas, const TimelineBlock& block, std::size_t member, double mean_share,
               const Rect& area);
/// "avoid.nearest (m)"
std::string name_of(const traces::TraceNumber& number);
/// A published number over time.
void draw_number(Canvas& canvas, const TimelineBlock& block, const traces::TraceNumber& number,
                 const Rect& area);

/// The nodes of a coordinator's graph that were lit in a span: a row for each, or for those that
/// were running the longest.
struct GraphRows {
  struct Row {
    std::size_t node;
    double indent;  // of its name, units
    double running_s;
  };
  const traces::TraceGraph* graph;
  std::vector<Row> rows;  // in the order of the graph
  std::size_t lit;        // the number of nodes that were

  double height() const;
};
inline constexpr double kGraphHead = 18.0, kGraphRow = 15.0;  // heights
/// Those of a robot that were lit.
std::vector<GraphRows> graph_rows(const traces::TraceRobot& robot, const traces::TimeSpan& span);
void draw_graph(Canvas& canvas, const TimelineBlock& block, const GraphRows& shown, double y);

/// The meaning of the numbers left of the lanes, on the line `y`.
void draw_lane_head(Canvas& canvas, const TimelineBlock& block, double y);
/// Marks the current path as silenced.
inline void hatch(Canvas& canvas, const Rect& around) {
  hatch(canvas, around, 6.0, kText.with_alpha(0.5));
}

}  // namespace elsie::picture

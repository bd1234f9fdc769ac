// The parts of a timeline; timeline.h says what they show.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "elsie/picture/timeline.h"

#include "canvas.h"
#include "panel.h"
#include "timeline_columns.h"

namespace elsie::picture {

/// Colours of behaviours: the same for behaviours of the same path, whatever the robot; those
/// inside another are shades of its colour.
class BehaviorInks {
 public:
  explicit BehaviorInks(const traces::Trace& trace);
  Ink of(const traces::TraceRobot& robot, int member) const;
  /// The member's, or grey for several at once, or the paper's for nobody.
  Ink of_decider(const traces::TraceRobot& robot, traces::Decider decider) const;

 private:
  std::map<std::string, Ink> by_path_;
};

/// Symbols of events, one for each name as long as there are enough.
class EventSymbols {
 public:
  EventSymbols(const traces::Trace& trace, const std::vector<std::size_t>& robots,
               const traces::TimeSpan& span);
  const std::vector<std::string>& names() const { return names_; }
  void draw(Canvas& canvas, const std::string& name, const Vector2& at) const;
  /// A rim of paper around the symbol, which tells it from those that were drawn before.
  void draw_rim(Canvas& canvas, const std::string& name, const Vector2& at) const;

 private:
  std::size_t place_of(const std::string& name) const;

  std::vector<std::string> names_;
};

/// The events of one name within a span of time.
struct EventKind {
  std::string name;
  std::vector<double> times_s;  // ascending
};

/// Of a robot, in the order in which each kind first happened.
std::vector<EventKind> event_kinds(const traces::TraceRobot& robot, const traces::TimeSpan& span);

/// With more kinds than this, a row for each would push the panels out of sight.
inline constexpr std::size_t kMostEventRows = 8;

/// Around the whole picture, units.
inline constexpr double kTimelineMargin = 18.0;

/// Names and numbers left of a plot: their distance and style.
inline constexpr double kBesidePlot = 10.0;
inline const TextStyle kBeside{
    .size = kTick, .ink = kFaintText, .across = Across::right, .down = Down::middle};

/// The least distance between the name of a behaviour and its priority, units.
inline constexpr double kNameToPriority = 12.0;

/// Lanes are paler than the other panels, so that lines over them are seen.
inline constexpr double kLaneAlpha = 0.55;

/// What all panels of a robot share.
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

/// Ticks of the times, up and down through the rectangle.
void draw_time_grid(Canvas& canvas, const TimelineBlock& block, const Rect& area);
/// Their labels, and what the axis is, below `y`.
void draw_time_axis(Canvas& canvas, const TimelineBlock& block, double y);

/// The events around the line `y` and, when `in_rows`, a row `row` lower for each further kind,
/// with its name and how often it happened. In one row, rare events are in front. Lines go down to
/// `bottom`, those of the rarest kinds first, up to a number.
void draw_events(Canvas& canvas, const TimelineBlock& block, const std::vector<EventKind>& kinds,
                 const EventSymbols& symbols, bool in_rows, double y, double row, double bottom);
void draw_deciders(Canvas& canvas, const TimelineBlock& block, const Rect& area);
void draw_shares(Canvas& canvas, const TimelineBlock& block, const Rect& area);
void draw_weights(Canvas& canvas, const TimelineBlock& block, const Rect& area);
/// `mean_share`: the member's part in the robot's command over the whole span.
void draw_lane(Canvas& canvas, const TimelineBlock& block, std::size_t member, double mean_share,
               const Rect& area);
/// What the numbers left of the lanes are, on the line `y`.
void draw_lane_head(Canvas& canvas, const TimelineBlock& block, double y);
/// Diagonals over the path, which is used up.
void hatch(Canvas& canvas, const Rect& around);

}  // namespace elsie::picture

// The parts of a page of plots; plot.h says what they show.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "elsie/picture/axis.h"
#include "elsie/picture/plot.h"

#include "canvas.h"

namespace elsie::picture {

// Text sizes.
inline constexpr double kPageTitle = 20.0;
inline constexpr double kPanelTitle = 15.0;
inline constexpr double kLabel = 13.0;
inline constexpr double kTick = 12.0;

/// Throws std::invalid_argument for an axis that cannot be drawn.
void check_panel(const Panel& panel);
/// The ratio of height to width that suits the panel without its head, in a panel of this width.
double natural_aspect(const Canvas& canvas, const Panel& panel, double width);
/// The height of a chart of rows without its head.
double natural_height(const Canvas& canvas, const RowChart& chart, double width);
/// The height that title and names above the plot need in a panel of this width.
double head_height(const Canvas& canvas, const LineChart& chart, double width);
double head_height(const Canvas& canvas, const RowChart& chart, double width);
template <class FieldPanel>
double head_height(const Canvas&, const FieldPanel& panel, double) {
  return panel.title.empty() ? 6 : kPanelTitle + 12;
}

/// `head` is at least head_height(): the largest in the row, so that plots line up.
void draw(Canvas& canvas, const LineChart& chart, const Rect& area, double head);
/// The plot of a line chart that is drawn there; returns the values of its x axis.
Interval place_plot(const Canvas& canvas, const LineChart& chart, const Rect& area, double head,
                    Rect& plot);
void draw(Canvas& canvas, const HeatMap& map, const Rect& area, double head);
void draw(Canvas& canvas, const Mesh& mesh, const Rect& area, double head);
void draw(Canvas& canvas, const Tiles& tiles, const Rect& area, double head);
void draw(Canvas& canvas, const RowChart& chart, const Rect& area, double head);

/// The width of a sample of a line in a legend.
inline constexpr double kSwatch = 26.0;
/// The colour of a series.
Ink ink_of(const LineChart& chart, std::size_t index);
/// A sample of a series, kSwatch wide.
void draw_swatch(Canvas& canvas, const LineChart& chart, std::size_t index, const Vector2& from);
/// The curves with all that belongs to them.
void draw_series(Canvas& canvas, const LineChart& chart, const PlaneMap& map, const Rect& plot);

/// A bar with the colours of an interval, and its ticks and label on the right.
void draw_colour_bar(Canvas& canvas, const Axis& axis, const Interval& range, const Rect& bar);
/// Fills the rectangle as one in which nothing is known.
void draw_unknown(Canvas& canvas, const Rect& area);

/// The axis' own limits, or else those of the interval.
Interval interval_of(const Axis& axis, const Interval& otherwise);
/// The interval of all finite values of the field; widened if they are equal.
Interval interval_of(const Field& field);

/// The map from the intervals to the rectangle.
PlaneMap map_to(const Rect& plot, const Interval& x, const Interval& y);

/// Grid, ticks, tick labels and axis labels around a plot.
void draw_axes(Canvas& canvas, const Rect& plot, const Axis& x, const Interval& x_range,
               const Axis& y, const Interval& y_range, bool grid = true);

/// Marks and numbers of the ticks below `y` or left of `x`. Returns the width of the widest number.
void draw_x_ticks(Canvas& canvas, const Ticks& ticks, const PlaneMap& map, double y);
double draw_y_ticks(Canvas& canvas, const Ticks& ticks, const PlaneMap& map, double x,
                    const Ink& ink);

/// The ticks of an axis that is `length` units long, about one for each `room` units.
Ticks ticks_of(const Axis& axis, const Interval& range, double length, double room = 45.0);

/// Whether some names of an x axis have a second row, because they are too long for one.
bool folds(const Canvas& canvas, const Axis& axis, const Interval& range, double width);
inline constexpr double kFold = 14.0;  // the height of that row

/// The width of tick labels left of a y axis.
double y_labels_width(const Canvas& canvas, const Axis& axis, const Interval& range, double height);

/// The chart with exponents of ten in place of the values of logarithmic axes.
LineChart in_exponents(LineChart chart);

/// Places for the entries of a legend, in rows of this width.
class Flow {
 public:
  Flow(double width, double gap) : width_(width), gap_(gap) {}
  int row() const { return row_; }  // of the last entry, from 0
  /// The left edge of the next entry.
  double place(double width) {
    if (next_ > 0.0 && next_ + width > width_) next_ = 0.0, ++row_;
    return std::exchange(next_, next_ + width + gap_);
  }

 private:
  double width_, gap_, next_ = 0.0;
  int row_ = 0;
};

/// Title and subtitles at the top of a picture. Return the lower edge of the last one.
double header_height(const std::string& title, const std::vector<std::string>& subtitles);
double draw_header(Canvas& canvas, const std::string& title,
                   const std::vector<std::string>& subtitles, double width);

/// Fills the current path with slanted lines, `every` units apart.
void hatch(Canvas& canvas, const Rect& around, double every, const Ink& ink);

/// The margin around a picture, units.
inline constexpr double kPageMargin = 18.0;

}  // namespace elsie::picture

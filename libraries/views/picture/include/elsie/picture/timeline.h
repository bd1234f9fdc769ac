// A coordination trace as a picture: who decided when, over the time of a run.
//
// For each robot, from above to below: its events, a row for each kind; a band that shows whose
// command counted most; the shares of its behaviours in the command, stacked; their weights; and a
// lane for each behaviour, those inside another below it, with the priority that the user gave it
// (and, where that was changed in the run, from where on it was which), its part in the robot's
// command, its activation, and when it was silenced.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "elsie/picture/size.h"
#include "elsie/traces/trace_account.h"

namespace elsie::picture {

/// Robots of which everything can be shown in one picture; with more, lanes and weights are left
/// out.
inline constexpr std::size_t kTimelineRobotsInFull = 3;

/// What to draw. The trace must live as long as the timeline.
struct Timeline {
  const traces::Trace& trace;
  std::vector<std::size_t> robots{};  // by their places in the trace; empty: all
  traces::TimeSpan span{};            // s
  /// Empty: the world's name.
  std::string title{};
  /// Lines below the title, such as the outcome of the run.
  std::vector<std::string> subtitles{};
};

/// Draws the timeline into a file whose suffix, .png or .svg, says of which type. The same timeline
/// gives the same bytes.
///
/// Time is cut into columns 1.5 units wide, a unit being a thousandth of the picture's width. Areas
/// show means over a column, lines the mean with its least and largest value as a band. A behaviour
/// that decided for a part of a column only, however short, has at least 0.3 of the column in the
/// band of deciders, less where there are more than three.
///
/// Throws std::invalid_argument for any other suffix, a size out of range, a robot that is not in
/// the trace, or so many robots that the picture would be higher than 16000 pixels;
/// std::runtime_error when the file cannot be written; then a file that was there before is
/// unchanged.
void save_timeline(const Timeline& timeline, const std::filesystem::path& file,
                   const Size& size = {});

}  // namespace elsie::picture

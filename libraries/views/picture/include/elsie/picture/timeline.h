// A coordination trace as a picture: who decided when, over the time of a run.
//
// For each robot, from top to bottom: its events, a row for each kind; a band in the colour of the
// behaviour whose command counted most; the shares of the behaviours in the command, stacked; their
// weights; and a lane for each behaviour, those inside another below it. A lane shows the user's
// priority and its changes in the run, the behaviour's part in the robot's command, its activation,
// and when it was silenced.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "elsie/picture/size.h"
#include "elsie/traces/trace_account.h"

namespace elsie::picture {

/// The most robots that are drawn in full; with more, lanes and weights are left out.
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

/// Draws the timeline into a file of the type that its suffix, .png or .svg, names. The same
/// timeline gives the same bytes.
///
/// Time is divided into columns 1.5 units wide; a unit is a thousandth of the picture's width.
/// Areas show means over a column; lines show the mean, with a band from the least to the largest
/// value. A behaviour that decided for any part of a column has at least 0.3 of its height in the
/// band of deciders, less where there are more than three.
///
/// Throws std::invalid_argument for any other suffix, a size out of range, a robot that is not in
/// the trace, or so many robots that the picture would be higher than 16000 pixels;
/// std::runtime_error when the file cannot be written. An existing file is unchanged then.
void save_timeline(const Timeline& timeline, const std::filesystem::path& file,
                   const Size& size = {});

}  // namespace elsie::picture

// A coordination trace as a picture: who decided when, over the time of a run.
//
// Each robot has, from top to bottom: its events, a row for each kind; a band with the behaviour
// whose command counted most; the shares of its behaviours in the command, stacked; their weights;
// and a lane for each behaviour, with inner ones below the outer one. A lane shows the priority
// that the user set (and since when, if it changed in the run), the share in the robot's command,
// the activation, and when the behaviour was silenced. Below them is a panel for each number that a
// plugin of the robot published, and for each coordinator that shows a graph a row for each node
// that was running, or succeeded or failed, with the part of the time in which it was running.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "elsie/api/image.h"
#include "elsie/picture/size.h"
#include "elsie/traces/trace_account.h"

namespace elsie::picture {

/// The most robots that are shown in full; with more, lanes and weights are left out.
inline constexpr std::size_t kTimelineRobotsInFull = 3;

/// The contents of a timeline. The trace must outlive it.
struct Timeline {
  const traces::Trace& trace;
  std::vector<std::size_t> robots{};  // indices into the trace; empty: all
  traces::TimeSpan span{};            // s
  /// Empty: the world's name.
  std::string title{};
  /// Lines below the title, such as the outcome of the run.
  std::vector<std::string> subtitles{};
};

/// Draws the timeline into a file of the type that the suffix names, .png or .svg. The same
/// timeline gives the same bytes.
///
/// Time is divided into columns 1.5 units wide; a unit is a thousandth of the picture's width.
/// Areas show means over a column, lines the mean, with the least and largest value as a band. A
/// behaviour that decided in part of a column, however short, gets at least 0.3 of the column in
/// the band of deciders, or less if there are more than three.
///
/// Throws std::invalid_argument for another suffix, a size out of range, a robot that is not in the
/// trace, or so many robots that the picture would exceed 16000 pixels in height;
/// std::runtime_error when the file cannot be written; an existing file is then unchanged.
void save_timeline(const Timeline& timeline, const std::filesystem::path& file,
                   const Size& size = {});

/// The colours that behaviours have in timelines, by their paths: equal for equal paths on all
/// robots.
std::map<std::string, Colour> behavior_colours(const traces::Trace& trace);

}  // namespace elsie::picture

// A world from above as a picture: the arena to scale, its bodies, the paths of the robots and the
// beams of their sensors.
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/picture/axis.h"
#include "elsie/picture/size.h"

namespace elsie::world {
struct World;
}

namespace elsie::picture {

/// One ray of a sensor, in the world's frame.
struct Beam {
  Vector2 from;
  Vector2 to;  // where it hit, or the end of its range
  bool hit = false;
};

/// A robot during a run. Body and team are those of the world's robot of this id; without such a
/// robot, the defaults.
struct RobotTrack {
  std::string id;
  std::vector<Pose> path;  // oldest first, TopView::path_period_s apart; may be empty
  Pose now;
  std::vector<Beam> beams;
  std::vector<Vector2> touches;  // where it collided
  std::vector<Pose> segments{};  // where those that it pulls are; missing ones are drawn in line
  std::vector<std::size_t> placed{};  // poses of the path that it did not drive to, ascending
};

/// Which parts of the paths are drawn; long paths of many robots hide each other.
struct PathChoice {
  std::vector<std::string> robots{};  // whose paths and collisions; empty: all
  /// The part of the run, s.
  double from_s = 0.0;
  double to_s = std::numeric_limits<double>::infinity();
  /// When positive, paths fade: what is older than this, counted from their end, is not drawn, s.
  double fade_s = 0.0;
};

/// What to draw. The world must live as long as the view.
struct TopView {
  const world::World& world;
  /// Other robots of the world are drawn where the world puts them.
  std::vector<RobotTrack> robots{};
  /// Where the world's boxes are now, in the world's order; nullopt: gone (a collected resource).
  /// Boxes past the end of the list are where the world puts them.
  std::vector<std::optional<Pose>> boxes{};
  /// Empty: the world's name.
  std::string title{};
  /// Lines below the title, such as the outcome of the run.
  std::vector<std::string> subtitles{};
  /// Simulated time between two poses of a path, s. When positive, the paths carry time marks.
  double path_period_s = 0.0;
  PathChoice paths{};
};

/// Draws the view into a file of the type that its suffix, .png or .svg, names. The same view gives
/// the same bytes. Text that is not UTF-8 is replaced, text that is too long is shortened.
/// Positions that are not finite are left out.
///
/// With a height of 0 the picture is as high as the arena needs, up to 1.5 times its width.
///
/// Throws std::invalid_argument for any other suffix or a size out of range, std::runtime_error
/// when the file cannot be written. An existing file is unchanged then.
void save_top_view(const TopView& view, const std::filesystem::path& file, const Size& size = {});

/// Maps points of the world (m) to the picture of save_top_view(), in pixels from its upper left
/// corner, for marks and texts over it.
PlaneMap top_view_map(const TopView& view, const Size& size = {});

}  // namespace elsie::picture

// A world from above as a picture: the arena to scale, what stands in it, where the robots went and
// what they saw.
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

/// What one ray of a sensor met, in the world's frame.
struct Beam {
  Vector2 from;
  Vector2 to;  // where it hit, or the end of its range
  bool hit = false;
};

/// A robot during a run. Body and team are those of the robot of this id in the world; for an id
/// that is not there, the defaults.
struct RobotTrack {
  std::string id;
  std::vector<Pose> path;  // oldest first, TopView::path_period_s apart; may be empty
  Pose now;
  std::vector<Beam> beams;
  std::vector<Vector2> touches;       // where it touched something that it should not have
  std::vector<Pose> segments{};       // where those that it pulls are; those missing stand in line
  std::vector<std::size_t> placed{};  // poses of the path that it did not drive to, ascending
};

/// Which parts of the paths are drawn. Where many robots drove long, all of them hide each other.
struct PathChoice {
  std::vector<std::string> robots{};  // whose paths and touches; empty: of all
  /// From when to when, in the time of the run, s.
  double from_s = 0.0;
  double to_s = std::numeric_limits<double>::infinity();
  /// When positive, paths fade away: what is this much older than the end of the path is gone, s.
  double fade_s = 0.0;
};

/// What to draw. The world must live as long as the view.
struct TopView {
  const world::World& world;
  /// Robots of the world that are not among them are drawn where the world puts them.
  std::vector<RobotTrack> robots{};
  /// Where the world's boxes are now, in the world's order; nullopt: no longer there (a collected
  /// resource). Boxes past the end of the list are where the world puts them.
  std::vector<std::optional<Pose>> boxes{};
  /// Empty: the world's name.
  std::string title{};
  /// Lines below the title, such as the outcome of the run.
  std::vector<std::string> subtitles{};
  /// Simulated time between two poses of a path, s. When positive, the paths carry time marks.
  double path_period_s = 0.0;
  PathChoice paths{};
};

/// Draws the view into a file whose suffix, .png or .svg, says of which type. The same view gives
/// the same bytes. Text may hold anything: what is not UTF-8 or too long for its place is replaced
/// or shortened. Positions that are not finite are left out.
///
/// With a height of 0 the picture is as high as the arena asks for, up to 1.5 times its width.
///
/// Throws std::invalid_argument for any other suffix or a size out of range, std::runtime_error
/// when the file cannot be written; then a file that was there before is unchanged.
void save_top_view(const TopView& view, const std::filesystem::path& file, const Size& size = {});

/// Where points of the world (m) land in the picture that save_top_view() makes, in pixels from its
/// upper left corner: for marks and texts to be laid over it.
PlaneMap top_view_map(const TopView& view, const Size& size = {});

}  // namespace elsie::picture

// A picture of a world from above: the arena to scale, with its objects, the paths of the robots,
// and what plugins draw.
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/api/image.h"
#include "elsie/api/sketch.h"
#include "elsie/picture/axis.h"
#include "elsie/picture/floor_field.h"
#include "elsie/picture/size.h"

namespace elsie::world {
struct Obstacle;
struct World;
}  // namespace elsie::world

namespace elsie::picture {

/// What an actuator of a robot shines.
struct Light {
  Vector2 place;
  Colour colour;
};

/// A robot during a run. Body and team are those of the robot with this id in the world; for an
/// unknown id, the defaults.
struct RobotTrack {
  std::string id;
  std::vector<Pose> path;  // oldest first, TopView::path_period_s apart; may be empty
  Pose now;
  std::vector<Sketch> sketches;       // of its plugins
  std::vector<Vector2> touches;       // its positions when it collided
  std::vector<Pose> segments{};       // poses of its segments; missing ones stand in line
  std::vector<std::size_t> placed{};  // indices of poses to which it did not drive, ascending
  double from_s = 0.0;                // time of the first pose of the path
  std::optional<Pose> believed{};     // where it takes itself to be; none: it knows
  std::vector<Pose> believed_path{};  // likewise, for each pose of the path; empty: it knows
  std::vector<Light> lights{};
};

/// The parts of the paths to draw. The long paths of many robots hide each other.
struct PathChoice {
  std::vector<std::string> robots{};  // robots whose paths and touches are drawn; empty: all
  /// The interval of the run's time, s.
  double from_s = 0.0;
  double to_s = std::numeric_limits<double>::infinity();
  /// If positive, paths fade: parts older than their end by this time are invisible, s.
  double fade_s = 0.0;
};

/// As many as a picture shows.
inline constexpr std::size_t kMostFieldTiles = 400;

/// The contents of a view. The world must outlive it.
struct TopView {
  const world::World& world;
  /// Robots of the world that are not listed are drawn at their start.
  std::vector<RobotTrack> robots{};
  /// What measures draw.
  std::vector<Sketch> sketches{};
  /// The fields of the world, in at most kMostFieldTiles columns and rows.
  std::vector<FloorField> fields{};
  /// The current poses of the world's boxes, in the world's order; nullopt: removed (a collected
  /// resource). Boxes beyond the end of the list are at their start.
  std::vector<std::optional<Pose>> boxes{};
  /// Empty: the world's name.
  std::string title{};
  /// Lines below the title, such as the outcome of the run.
  std::vector<std::string> subtitles{};
  /// Simulated time between the poses of a path, s. If positive, the paths have time marks.
  double path_period_s = 0.0;
  PathChoice paths{};
  /// The arena alone, without title, axes, legend and names: for small pictures.
  bool bare = false;
};

/// Where a box begins: in the file, or where a rule or an edit put it last.
Pose start_of(const world::Obstacle& box);

/// Draws the view into a file of the type that the suffix names, .png or .svg. The same view gives
/// the same bytes. Texts may be any bytes: those that are not UTF-8 are replaced, and long texts
/// shortened. Positions that are not finite are left out.
///
/// With a height of 0 the picture is as high as the arena needs, up to 1.5 times its width.
///
/// Throws std::invalid_argument for another suffix or a size out of range, std::runtime_error when
/// the file cannot be written; an existing file is then unchanged.
void save_top_view(const TopView& view, const std::filesystem::path& file, const Size& size = {});

/// The same picture as the text of an SVG, or pixel by pixel in red, green and blue. Throws
/// std::invalid_argument for a size out of range.
std::string top_view_svg(const TopView& view, const Size& size = {});
Image top_view_image(const TopView& view, const Size& size = {});

}  // namespace elsie::picture

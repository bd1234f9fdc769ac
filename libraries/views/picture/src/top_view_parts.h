// The parts of the top view: its layout and the functions that draw it.
//
// Drawing runs from the floor upwards: grid, image, patches and fields of the floor, marks (goals,
// chargers), boxes, paths, sketches, robots, touches, walls, lamps, labels.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "elsie/picture/axis.h"
#include "elsie/picture/colours.h"
#include "elsie/picture/top_view.h"
#include "elsie/world/parts.h"

#include "canvas.h"
#include "label_placer.h"
#include "legend.h"

namespace elsie::picture {

/// A robot with everything that drawing it needs.
struct DrawnRobot {
  RobotTrack track;
  BodyPlan plan;  // its vehicles after the first are the segments in the track
  Ink ink;        // its team's colour, varied by member
  Ink team;       // its team's colour
  std::string team_id;
};

/// A view, completed from its world.
struct Scene {
  const world::World& world;
  std::vector<DrawnRobot> robots;
  std::vector<Sketch> sketches;  // of measures
  std::vector<FloorField> fields;
  std::vector<std::optional<Pose>> boxes;  // one for each box of the world
  std::string title;
  std::vector<std::string> subtitles;
  double path_period_s = 0.0;
  /// Time between marks on the paths, s; 0: none.
  double mark_every_s = 0.0;
  PathChoice paths{};
  bool bare = false;

  /// Whether there are too many robots for rings, names, sketches and marks on their paths.
  bool is_crowd() const { return robots.size() > kMostInDetail; }
  static constexpr std::size_t kMostInDetail = 400;
};
Scene complete(const TopView& view);

inline bool finite(const Pose& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading_rad);
}

/// The colour of a team; see world::team_colour().
Ink team_ink(const world::World& world, const std::string& team);
/// The colour of a resource, as cameras see it.
Ink resource_ink(const world::World& world, const world::Obstacle& resource);

/// The colour of a nest's edge: its team's, or a darker one of its own.
Ink nest_edge(const world::World& world, const world::Nest& nest);
inline constexpr double kNestEdge = 2.2;

/// What the picture needs to explain.
std::vector<LegendEntry> legend_of(const Scene& scene);

/// Adds what plugins draw.
void add_sketches(const Scene& scene, std::vector<LegendEntry>& entries);

/// The layout in units of the drawing.
struct Layout {
  double zoom = 1.0;
  int width = 0, height = 0;  // of the picture, pixels
  Rect plot;                  // the part with the world
  Rect arena;                 // inside of the walls
  PlaneMap map;               // from m to units
  static constexpr double kSmallestBox = 4.0;
  double smallest_box = kSmallestBox;  // edge; less where there are very many
  LegendLayout legend;
  Vector2 legend_corner;
};
/// `zoom`: pixels per unit.
Layout lay_out(const Scene& scene, const std::vector<LegendEntry>& entries, const Size& size,
               double zoom);

/// A point of a path in the picture, with the fraction of the path's time.
struct PathStep {
  Vector2 at;
  double part = 0.0;
  bool driven = true;  // from the step before; else the robot was placed here
};
/// The path without points that make no visible difference, those less than `apart` units from the
/// one before: a run of ten minutes has tens of thousands of points.
std::vector<PathStep> visible_steps(const Layout& layout, const RobotTrack& track, double apart);

/// The corners of an outline at a place, in the picture.
std::vector<Vector2> pixels(const PlaneMap& map, const Pose& pose, std::vector<Vector2> corners);

// The parts of the picture. Each takes the labels to place, or adds areas that labels should avoid.
void draw_floor(Canvas& canvas, const Scene& scene, const Layout& layout);
/// The image, the patches and the fields, over the grid.
void draw_floor_marks(Canvas& canvas, const Scene& scene, const Layout& layout);
void draw_lamps(Canvas& canvas, const Scene& scene, const Layout& layout);
/// The names of lamps and nests.
void draw_floor_labels(Canvas& canvas, const Scene& scene, const Layout& layout,
                       LabelPlacer& labels);
void draw_walls(Canvas& canvas, const Scene& scene, const Layout& layout);
void draw_frame(Canvas& canvas, const Scene& scene, const Layout& layout);
void draw_goals(Canvas& canvas, const Scene& scene, const Layout& layout);
void draw_chargers(Canvas& canvas, const Scene& scene, const Layout& layout);
void draw_boxes(Canvas& canvas, const Scene& scene, const Layout& layout, LabelPlacer& labels);
void draw_paths(Canvas& canvas, const Scene& scene, const Layout& layout, LabelPlacer& labels);
void draw_sketches(Canvas& canvas, const Scene& scene, const Layout& layout, LabelPlacer& labels);
/// Where robots take themselves to be: the path as a dotted line, the body with a dashed outline.
void draw_beliefs(Canvas& canvas, const Scene& scene, const Layout& layout);
void draw_robots(Canvas& canvas, const Scene& scene, const Layout& layout, LabelPlacer& labels);
void draw_touches(Canvas& canvas, const Scene& scene, const Layout& layout);
/// All robots of a crowd with their paths and touches.
void draw_crowd(Canvas& canvas, const Scene& scene, const Layout& layout);
void draw_robot_labels(Canvas& canvas, const Scene& scene, const Layout& layout,
                       LabelPlacer& labels);
void draw_goal_labels(Canvas& canvas, const Scene& scene, const Layout& layout,
                      LabelPlacer& labels);

/// Writes a text next to a mark, if there is room, with a line to the mark if it is far away.
void draw_label(Canvas& canvas, LabelPlacer& labels, const std::string& text, const Vector2& middle,
                double radius, const TextStyle& style);
/// The number of labels without a place, in the lower right corner of the arena.
void draw_left_out(Canvas& canvas, const Layout& layout, const LabelPlacer& labels);

// Symbols in both the legend and the drawing.
void draw_resource_mark(Canvas& canvas, const Vector2& at, double radius, const Ink& ink);
void draw_bolt(Canvas& canvas, const Vector2& at, double radius, const Ink& ink);
void draw_sun(Canvas& canvas, const Vector2& at, const Ink& light);
void draw_touch(Canvas& canvas, const Vector2& at);
void draw_robot_symbol(Canvas& canvas, const Vector2& at, double heading_rad, const Ink& ink);
void draw_crowd_symbol(Canvas& canvas, const Vector2& at, const Ink& ink);
void draw_crowd_path_symbol(Canvas& canvas, const Vector2& at, const Ink& ink);
void draw_crowd_touch_symbol(Canvas& canvas, const Vector2& at);
/// A filled arrow head with its tip at `tip`; `angle` is its direction in the picture.
void draw_arrow_head(Canvas& canvas, const Vector2& tip, double angle, double length,
                     const Ink& ink);
/// Fills the current path and hatches it within `box`; in a page, which clips to rectangles only,
/// without the hatching.
void fill_hatched(Canvas& canvas, const Rect& box, const Ink& ground, const Ink& lines);

inline constexpr Ink kFloor = hex(0xfafaf8, "floor");
inline constexpr Ink kWall = hex(0x4a4f57, "wall");
inline constexpr Ink kFixedBox = hex(0xa89d90, "box");
inline constexpr Ink kFixedEdge = hex(0x6f655a, "quiet");
inline constexpr Ink kDynamicBox = hex(0xf3e3bd);
inline constexpr Ink kDynamicEdge = hex(0x8a6a14);
inline constexpr Ink kMovingBox = hex(0xcbb3dd);
inline constexpr Ink kMovingEdge = hex(0x6b3f8f);
inline constexpr Ink kGoal{kGoalColour.red / 255.0, kGoalColour.green / 255.0,
                           kGoalColour.blue / 255.0, 1.0, "good"};
inline constexpr Ink kBeam = hex(0xb07500);
inline constexpr Ink kTouch = hex(0xc4002f);

/// Half the width from which a chassis shows its shape; smaller ones get a ring.
inline constexpr double kLegibleChassis = 11.0;
inline constexpr double kRing = 10.0;
/// The radius around a robot that labels avoid.
double robot_radius(const DrawnRobot& robot, const Layout& layout);

}  // namespace elsie::picture

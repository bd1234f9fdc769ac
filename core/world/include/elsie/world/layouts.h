// Layouts: what of a world is drawn anew from each seed. <layouts> stands in a world's file, and
// what runs has the robots and boxes that came out of it instead.
//
// The core knows the vocabulary. What draws is the library plugin::layouts_file(), which is loaded
// for worlds that have layouts. docs/random-worlds.md says what they mean.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "elsie/world/markup.h"
#include "elsie/world/reader.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

class Files;

// Where a thing of a <scatter> may stand. Lengths in m.
struct InBox {
  double x = 0.0, y = 0.0;
  std::optional<double> length, width;  // default: the arena's
  double heading_deg = 0.0;
};
struct InDisc {
  double x = 0.0, y = 0.0, radius = 1.0;
};
struct InRing {
  double x = 0.0, y = 0.0, inner = 1.0, outer = 2.0;
};
struct Gaussian {
  double x = 0.0, y = 0.0, sd = 1.0;
};
struct OnGrid {
  double x = 0.0, y = 0.0;
  std::optional<double> length, width;  // default: the arena's
  int columns = 3, rows = 3;
  double jitter = 0.0;
};
struct OnLine {
  double x1 = -1.0, y1 = 0.0, x2 = 1.0, y2 = 0.0;
  bool even = false;
};
using Region = std::variant<InBox, InDisc, InRing, Gaussian, OnGrid, OnLine>;

struct HeadingRule {
  std::string rule = "uniform";
  double deg = 0.0, from_deg = 0.0, to_deg = 360.0, sd_deg = 30.0;
  double x = 0.0, y = 0.0;
  Location location{};
};
struct KeepClear {
  double x = 0.0, y = 0.0, radius = 0.5;
};
struct Draw {
  std::string id, path;
  std::optional<double> from, to, mean, sd;
  bool whole = false;
  Location location{};
};
struct Scatter {
  std::string id;
  std::optional<int> count;
  std::optional<double> density;
  double gap = 0.05;
  int tries = 1000;
  std::vector<Region> regions;
  std::optional<HeadingRule> heading;
  std::vector<KeepClear> clear;
  std::vector<Draw> draws;
  Location location{};
};
/// What mazes and rooms have in common: an area and its walls.
struct WalledArea {
  std::string id;
  double x = 0.0, y = 0.0;
  std::optional<double> length, width;  // default: the arena's
  double wall_thickness = 0.1, wall_height = 0.3;
  bool border = false;
  Location location{};
};
struct Maze : WalledArea {
  int columns = 6, rows = 6;
};
struct Rooms : WalledArea {
  double door = 0.8, smallest = 1.5;
};
struct PlanWall {
  double x1 = 0.0, y1 = 0.0, x2 = 0.0, y2 = 0.0;
};
struct FloorPlan {
  std::string id, file;
  double x = 0.0, y = 0.0;
  double metres_per_pixel = 0.05;
  double threshold = 0.5;
  double wall_thickness = 0.1, wall_height = 0.3;
  std::vector<PlanWall> walls;
  Location location{};
};
struct Layouts {
  std::optional<std::int64_t> seed;  // default: the run's
};

/// <layouts> with all in it. `things`: what a <scatter> may scatter.
ElementSpec layouts_spec(const std::vector<ElementSpec>& things);

/// Replaces the <layouts> of a world's tree, if there are any, by what they draw: ReadOptions::seed
/// is the run's. `drawn` gets the seed. Templates must have been merged. Adds a problem for
/// everything that cannot be drawn. Throws PluginError if the library cannot be loaded.
void draw_layouts(Element& world, const std::string& file, const plugin::Host& host,
                  const Files& files, const ReadOptions& options, std::optional<Drawn>& drawn,
                  Problems& problems);

/// What the library exports by the name `elsie_draw_layouts`. `layouts` has been taken out of
/// `world`.
using DrawLayouts = void(Element& world, const Element& layouts, std::uint64_t seed,
                         const std::string& file, const plugin::Host& host, const Files& files,
                         const ReadOptions& options, Problems& problems);

}  // namespace elsie::world

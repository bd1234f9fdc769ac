// Layouts as their elements describe them, checked.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "drawing.h"

namespace elsie::layouts {

// Where a thing of a <scatter> may stand. Lengths in m.
struct InBox {
  Area area;
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
  Area area;
  int columns = 3, rows = 3;
  double jitter = 0.0;
};
struct OnLine {
  double x1 = -1.0, y1 = 0.0, x2 = 1.0, y2 = 0.0;
  bool even = false;
};
using Region = std::variant<InBox, InDisc, InRing, Gaussian, OnGrid, OnLine>;

struct HeadingRule {
  std::string rule;
  double deg = 0.0, from_deg = 0.0, to_deg = 0.0, sd_deg = 0.0;
  double x = 0.0, y = 0.0;
  Location location;
};

struct Draw {
  std::string id, path;
  std::optional<double> from, to, mean, sd;
  bool whole = false;
  Location location;
};

struct Scatter {
  const Element* element = nullptr;
  std::string id;
  std::optional<int> count;
  std::optional<double> density;
  double gap = 0.0;
  int tries = 0;
  std::vector<const Element*> things;
  std::vector<Region> regions;
  std::optional<HeadingRule> heading;
  std::vector<InDisc> clear;
  std::vector<Draw> draws;
  Location location;
};

/// What mazes and rooms have in common: an area and its walls.
struct WalledArea {
  const Element* element = nullptr;
  std::string id;
  Area area;
  double wall_thickness = 0.0, wall_height = 0.0;
  bool border = false;
  Location location;
};
struct Maze : WalledArea {
  int columns = 0, rows = 0;
};
struct Rooms : WalledArea {
  double door = 0.0, smallest = 0.0;
};

struct FloorPlan {
  const Element* element = nullptr;
  std::string id, file;
  double x = 0.0, y = 0.0;
  double metres_per_pixel = 0.0;
  double threshold = 0.0;
  double wall_thickness = 0.0, wall_height = 0.0;
  std::vector<Wall> walls;
  Location location;
};

struct Described {
  std::uint64_t seed = 0;
  bool by_run = false;
  std::vector<Scatter> scatters;
  std::vector<Maze> mazes;
  std::vector<Rooms> rooms;
  std::vector<FloorPlan> plans;
  std::vector<Draw> draws;
};

/// Reads <layouts>, from which edits may have removed some. Adds a problem for each mistake. The
/// result refers to the elements.
Described described(const Element& layouts, const world::Arena& arena, std::uint64_t seed_of_run,
                    Problems& problems);

// Each draws one layout, or adds problems.
void draw_maze(Drawing& drawing, const Maze& maze);
void draw_rooms(Drawing& drawing, const Rooms& rooms);
void draw_floor_plan(Drawing& drawing, const FloorPlan& plan);

}  // namespace elsie::layouts

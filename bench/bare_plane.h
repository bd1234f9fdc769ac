// The least that a planar simulation can cost: one loop over discs and boxes, without plugins,
// masses or heights.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/world/description.h"

#include "arena_of_robots.h"

namespace elsie::bench {

/// Discs that drive on exact arcs, steer by eight beams of 1 m, and are pushed out of each other,
/// of boxes and of walls. A grid of 1 m finds what is near.
class BarePlane {
 public:
  BarePlane(std::span<const Pose> poses, std::span<const world::Obstacle> boxes,
            const world::Physics& physics, const world::Arena& arena);

  void step();
  Pose pose(std::size_t robot) const;

 private:
  struct Point {
    double x, y;
  };
  struct Disc {
    Point at;
    Point ahead;                     // a unit vector
    double left = 0.0, right = 0.0;  // rad/s
    std::size_t cell = 0;
  };
  struct Block {
    Point at;
    Point ahead;
    Point half;
  };

  int column(double place) const;
  template <class Visit>
  void near(const Disc& disc, const Visit& visit) const;
  void sort_into_cells();
  void steer_by_beams(Disc& disc);
  void drive(Disc& disc) const;
  void part(Disc& disc);
  static double distance_to(const Block& block, const Point& from, const Point& along);

  double half_;  // of the arena, m
  int columns_;
  double step_;
  double wheel_radius_, half_axle_, radius_, front_;
  std::vector<Block> blocks_;
  std::vector<std::vector<std::size_t>> blocks_in_;  // of each cell
  std::vector<Disc> discs_;
  std::vector<std::size_t> first_, sorted_, next_;  // discs by cells
  std::vector<Point> beams_;                        // directions from the heading
};

}  // namespace elsie::bench

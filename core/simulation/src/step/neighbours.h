// Finds robots near a place.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/base/grid.h"
#include "elsie/world/description.h"

namespace elsie::simulation {

class Neighbours {
 public:
  explicit Neighbours(const world::Arena& arena) : grid_(arena.length, arena.width) {}

  /// Sets the present position of a robot.
  void place(std::size_t robot, const Vector2& at);
  /// All robots within `reach` of the place, m, along x and along y, and perhaps others, in the
  /// order of their indices. Valid until `memory` changes.
  std::span<const base::Grid::Id> near(const Vector2& place, double reach,
                                       std::vector<base::Grid::Id>& memory) const;

 private:
  base::Grid grid_;
  std::vector<base::Grid::Block> cells_;  // of each robot: one cell
  std::vector<base::Grid::Id> all_;
};

}  // namespace elsie::simulation

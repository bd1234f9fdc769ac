// Finds robots near a place.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/base/grid.h"
#include "elsie/world/description.h"

namespace elsie::simulation {

class Robot;

class Neighbours {
 public:
  explicit Neighbours(const world::Arena& arena) : length_(arena.length), width_(arena.width) {}

  /// Sets the robots, which do not move before the next call. `at_once` finds their cells now, not
  /// in the call of the first plugin that asks, which would count their memory.
  void begin(std::span<const std::shared_ptr<Robot>> robots, bool at_once) {
    robots_ = robots;
    is_placed_ = false;
    if (at_once) place_all();
  }
  /// All robots within `reach` of the place, m, along x and along y, and perhaps others, in the
  /// order of their indices. Valid until `memory` changes.
  std::span<const base::Grid::Id> near(const Vector2& place, double reach,
                                       std::vector<base::Grid::Id>& memory) const;

 private:
  void place_all() const;

  double length_, width_;  // of the arena, m
  std::span<const std::shared_ptr<Robot>> robots_;
  // Made when it is first needed, by one of the threads that need it.
  mutable std::mutex placing_;
  mutable std::atomic<bool> is_placed_ = false;
  mutable std::optional<base::Grid> grid_;
  mutable std::vector<base::Grid::Block> cells_;  // of each robot: one cell
  mutable std::vector<base::Grid::Id> all_;
};

}  // namespace elsie::simulation

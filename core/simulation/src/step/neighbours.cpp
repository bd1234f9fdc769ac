#include "step/neighbours.h"

#include <algorithm>

#include "robot/robot.h"

namespace elsie::simulation {

void Neighbours::place_all() const {
  const std::scoped_lock lock(placing_);
  if (is_placed_) return;
  if (!grid_) grid_.emplace(length_, width_);
  for (base::Grid::Id i = 0; i < robots_.size(); ++i) {
    if (i == cells_.size()) {
      cells_.emplace_back();
      all_.push_back(i);
    }
    const Pose& at = robots_[i]->truth().pose;
    const base::Grid::Block cell = grid_->block(at.x, at.y, at.x, at.y);
    if (cell == cells_[i]) continue;
    grid_->erase(i, cells_[i]);
    grid_->insert(i, cell);
    cells_[i] = cell;
  }
  is_placed_ = true;
}

std::span<const base::Grid::Id> Neighbours::near(const Vector2& place, double reach,
                                                 std::vector<base::Grid::Id>& memory) const {
  if (!is_placed_) place_all();
  constexpr std::size_t kFew = 8;
  if (all_.size() <= kFew) return all_;
  const base::Grid::Block block =
      grid_->block(place.x - reach, place.y - reach, place.x + reach, place.y + reach);
  // A check of a few robots is faster than a search in many cells.
  const int cells = (block.x1 - block.x0 + 1) * (block.y1 - block.y0 + 1);
  if (all_.size() <= static_cast<std::size_t>(cells)) return all_;
  memory.clear();
  for (int y = block.y0; y <= block.y1; ++y) {
    for (int x = block.x0; x <= block.x1; ++x) {
      const auto cell = grid_->cell(x, y);
      memory.insert(memory.end(), cell.begin(), cell.end());
    }
  }
  std::sort(memory.begin(), memory.end());
  return memory;
}

}  // namespace elsie::simulation

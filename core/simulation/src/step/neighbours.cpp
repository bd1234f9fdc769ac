#include "step/neighbours.h"

#include <algorithm>

#include "step/robot.h"

namespace elsie::simulation {

void Neighbours::place_all() const {
  const std::scoped_lock lock(placing_);
  if (is_placed_) return;
  if (!grid_) grid_.emplace(length_, width_);
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const Pose& pose = robots_[i]->state().pose;
    place(i, {pose.x, pose.y});
  }
  is_placed_ = true;
}

void Neighbours::place(std::size_t robot, const Vector2& at) const {
  const auto id = static_cast<base::Grid::Id>(robot);
  const base::Grid::Block cell = grid_->block(at.x, at.y, at.x, at.y);
  for (std::size_t next = cells_.size(); next <= robot; ++next) {
    cells_.emplace_back();
    all_.push_back(static_cast<base::Grid::Id>(next));
  }
  if (cell != cells_[robot]) {
    grid_->erase(id, cells_[robot]);
    grid_->insert(id, cell);
    cells_[robot] = cell;
  }
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

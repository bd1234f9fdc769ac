#include "step/neighbours.h"

#include <algorithm>

namespace elsie::simulation {

void Neighbours::place(std::size_t robot, const Vector2& at) {
  const auto id = static_cast<base::Grid::Id>(robot);
  const base::Grid::Block cell = grid_.block(at.x, at.y, at.x, at.y);
  cells_.resize(std::max(cells_.size(), robot + 1));
  if (cell != cells_[robot]) {
    grid_.erase(id, cells_[robot]);
    grid_.insert(id, cell);
    cells_[robot] = cell;
  }
}

std::span<const base::Grid::Id> Neighbours::near(const Vector2& place, double reach) const {
  found_.clear();
  const base::Grid::Block block =
      grid_.block(place.x - reach, place.y - reach, place.x + reach, place.y + reach);
  for (int y = block.y0; y <= block.y1; ++y) {
    for (int x = block.x0; x <= block.x1; ++x) {
      const auto cell = grid_.cell(x, y);
      found_.insert(found_.end(), cell.begin(), cell.end());
    }
  }
  std::sort(found_.begin(), found_.end());
  return found_;
}

}  // namespace elsie::simulation

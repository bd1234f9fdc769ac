#include "elsie/base/grid.h"

#include <algorithm>
#include <cmath>

namespace elsie::base {
namespace {

// A few robots wide, so that a ray of one metre crosses few cells and a cell holds few bodies.
constexpr double kCellSize = 0.4;        // m
constexpr double kMostCellsASide = 200;  // then the cells grow

}  // namespace

Grid::Grid(double length, double width)
    : cell_size_(std::max(kCellSize, std::max(length, width) / kMostCellsASide)),
      per_cell_(1.0 / cell_size_),
      left_(-0.5 * length),
      bottom_(-0.5 * width),
      columns_(std::max(1, static_cast<int>(std::ceil(length / cell_size_)))),
      rows_(std::max(1, static_cast<int>(std::ceil(width / cell_size_)))),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void Grid::insert(Id id, const Block& block) {
  for (int y = block.y0; y <= block.y1; ++y) {
    for (int x = block.x0; x <= block.x1; ++x) {
      cells_[index(x, y)].push_back(id);
    }
  }
}

void Grid::erase(Id id, const Block& block) {
  for (int y = block.y0; y <= block.y1; ++y) {
    for (int x = block.x0; x <= block.x1; ++x) {
      std::erase(cells_[index(x, y)], id);
    }
  }
}

}  // namespace elsie::base

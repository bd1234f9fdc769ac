// A uniform grid over the floor that stores which objects are in each cell.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace elsie::base {

/// Cells at the border reach to infinity, so that an object outside of the arena is still found.
class Grid {
 public:
  using Id = std::uint32_t;

  /// A block of cells, bounds included.
  struct Block {
    int x0 = 0, y0 = 0, x1 = -1, y1 = -1;

    friend bool operator==(const Block&, const Block&) = default;
  };

  /// A grid over the rectangle of this size, m, around the origin.
  Grid(double length, double width);

  /// The cells of a rectangle, m.
  Block block(double x0, double y0, double x1, double y1) const {
    return {column(x0), row(y0), column(x1), row(y1)};
  }
  void insert(Id id, const Block& block);
  void erase(Id id, const Block& block);

  std::span<const Id> cell(int x, int y) const { return cells_[index(x, y)]; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int column(double x) const { return clamped((x - left_) * per_cell_, columns_); }
  int row(double y) const { return clamped((y - bottom_) * per_cell_, rows_); }
  /// The x (y) of the border between column (row) i - 1 and i.
  double column_border(int i) const { return left_ + i * cell_size_; }
  double row_border(int i) const { return bottom_ + i * cell_size_; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(x);
  }
  static int clamped(double place, int count) {
    // With this comparison, NaN goes to the first cell.
    if (!(place > 0.0)) return 0;
    return place < count ? static_cast<int>(place) : count - 1;
  }

  double cell_size_;
  double per_cell_;
  double left_;
  double bottom_;
  int columns_;
  int rows_;
  std::vector<std::vector<Id>> cells_;
};

}  // namespace elsie::base

// Perfect mazes, with exactly one way between any two cells. They are made depth first, which gives
// long winding corridors.
#include <array>
#include <vector>

#include "elsie/base/number_text.h"

#include "described.h"

namespace elsie::layouts {

namespace {

class Cells {
 public:
  Cells(int columns, int rows)
      : columns_(columns),
        rows_(rows),
        open_east_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), false),
        open_north_(open_east_.size(), false) {}

  /// Opens walls until all cells are connected: from a cell to an unconnected neighbour, or back if
  /// there is none.
  void connect(Random& random) {
    std::vector<bool> reached(open_east_.size(), false);
    std::vector<std::size_t> way{drawn_index(random, open_east_.size())};
    reached[way.back()] = true;
    while (!way.empty()) {
      const int x = static_cast<int>(way.back()) % columns_;
      const int y = static_cast<int>(way.back()) / columns_;
      std::array<std::array<int, 2>, 4> steps{};
      std::size_t count = 0;
      for (const auto& step : {std::array{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
        if (is_inside(x + step[0], y + step[1]) && !reached[index(x + step[0], y + step[1])]) {
          steps[count++] = step;
        }
      }
      if (count == 0) {
        way.pop_back();
        continue;
      }
      const auto [dx, dy] = steps[drawn_index(random, count)];
      (dx != 0 ? open_east_ : open_north_)[index(x + std::min(dx, 0), y + std::min(dy, 0))] = true;
      way.push_back(index(x + dx, y + dy));
      reached[way.back()] = true;
    }
  }

  bool wall_east(int x, int y) const { return !open_east_[index(x, y)]; }
  bool wall_north(int x, int y) const { return !open_north_[index(x, y)]; }

 private:
  bool is_inside(int x, int y) const { return x >= 0 && x < columns_ && y >= 0 && y < rows_; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(x);
  }

  int columns_, rows_;
  std::vector<bool> open_east_, open_north_;
};

}  // namespace

void draw_maze(Drawing& drawing, const Maze& maze) {
  if (!drawing.require_inside(maze.area, maze.location, maze.id)) {
    return;
  }
  // The middles of its walls.
  const Area area = maze.border ? maze.area.shrunk(0.5 * maze.wall_thickness) : maze.area;
  const double length = area.length / maze.columns, width = area.width / maze.rows;
  if (std::min(length, width) <= maze.wall_thickness) {
    drawing.refuse(maze.location, maze.id,
                   "has cells of " + base::number_text(rounded_m(length)) + " m by " +
                       base::number_text(rounded_m(width)) + " m, and walls of " +
                       base::number_text(maze.wall_thickness) +
                       " m leave no room in them; give it fewer columns and rows");
    return;
  }
  Cells cells(maze.columns, maze.rows);
  Random random = drawing.stream(maze.id);
  cells.connect(random);
  std::size_t count = 0;
  // Walls in line are one box. `from` and `to` count cells.
  const auto add = [&](double x1, double y1, double x2, double y2) {
    drawing.add_wall(maze.id + "_" + std::to_string(++count),
                     {area.left() + length * x1, area.bottom() + width * y1,
                      area.left() + length * x2, area.bottom() + width * y2},
                     maze.wall_thickness, maze.wall_height, maze.location);
  };
  for (int x = 0; x + 1 < maze.columns; ++x) {
    for (int from = 0, to; from < maze.rows; from = to + 1) {
      for (to = from; to < maze.rows && cells.wall_east(x, to); ++to) {
      }
      if (to > from) add(x + 1, from, x + 1, to);
    }
  }
  for (int y = 0; y + 1 < maze.rows; ++y) {
    for (int from = 0, to; from < maze.columns; from = to + 1) {
      for (to = from; to < maze.columns && cells.wall_north(to, y); ++to) {
      }
      if (to > from) add(from, y + 1, to, y + 1);
    }
  }
  if (maze.border) {
    add(0, 0, maze.columns, 0);
    add(maze.columns, 0, maze.columns, maze.rows);
    add(maze.columns, maze.rows, 0, maze.rows);
    add(0, maze.rows, 0, 0);
  }
}

}  // namespace elsie::layouts

// The part of the arena that robots visited, in cells of a grid.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <elsie/base/number_text.h>

#include "chosen_robots.h"

namespace {

class Coverage final : public elsie::Measure, public ChosenRobots {
 public:
  double cell = 0.5;

  void equipped(const elsie::Observation& start) override {
    choose(start);
    length_ = start.arena_length_m;
    width_ = start.arena_width_m;
    const double columns = cells_in(length_), rows = cells_in(width_);
    if (columns * rows > kMostCells) {
      const auto text = [](double value) { return elsie::base::number_text(value, 6); };
      throw std::invalid_argument("its grid would have " + text(columns) + " x " + text(rows) +
                                  " cells; make 'cell' larger, so that there are at most " +
                                  text(kMostCells));
    }
    columns_ = static_cast<std::size_t>(columns);
    visited_.assign(columns_ * static_cast<std::size_t>(rows), false);
  }
  std::vector<elsie::Quantity> quantities() const override {
    return {{"share", "", "part of the arena that was visited"},
            {"area_m2", "m2", "area of the cells that were visited"}};
  }
  void reset(elsie::Random&) override {
    std::fill(visited_.begin(), visited_.end(), false);
    area_ = 0.0;
  }
  void observe(const elsie::Observation& now) override {
    for (const std::size_t i : chosen()) {
      visit(now.robots[i].pose);
    }
  }
  void report(const elsie::RunEnd&, std::span<std::optional<double>> values) const override {
    values[0] = area_ / (length_ * width_);
    values[1] = area_;
  }

  /// The outline of what was visited.
  void sketch(elsie::Sketch& sketch) const override {
    const std::size_t rows = visited_.size() / columns_;
    outline(
        sketch, rows, columns_,
        [this](std::size_t row, std::size_t column, bool is_end) {
          return elsie::Vector3{place(column + (is_end ? 1 : 0), columns_, length_),
                                place(row, visited_.size() / columns_, width_), kAbove};
        },
        [this](std::size_t row, std::size_t column) { return visited_[row * columns_ + column]; });
    outline(
        sketch, columns_, rows,
        [this](std::size_t column, std::size_t row, bool is_end) {
          return elsie::Vector3{place(column, columns_, length_),
                                place(row + (is_end ? 1 : 0), visited_.size() / columns_, width_),
                                kAbove};
        },
        [this](std::size_t column, std::size_t row) { return visited_[row * columns_ + column]; });
  }

 private:
  static constexpr double kAbove = 0.002;  // m, of its outline, the floor
  /// Lines between cells of neighbouring rows of which only one was visited, each as long as that
  /// is so.
  template <class Corner, class Visited>
  static void outline(elsie::Sketch& sketch, std::size_t rows, std::size_t columns,
                      const Corner& corner, const Visited& visited) {
    for (std::size_t row = 0; row <= rows; ++row) {
      std::size_t from = columns;  // where a line begins; none yet
      for (std::size_t column = 0; column <= columns; ++column) {
        const bool is_border = column < columns && (row > 0 && visited(row - 1, column)) !=
                                                       (row < rows && visited(row, column));
        if (is_border && from == columns) from = column;
        if (!is_border && from < columns) {
          if (2 * sketch.marks().size() + 2 > elsie::Sketch::kMostPlaces) return;
          sketch.line(elsie::SketchRole::field, corner(row, from, false),
                      corner(row, column - 1, true));
          from = columns;
        }
      }
    }
  }
  /// The border before a cell.
  double place(std::size_t index, std::size_t of, double side) const {
    return (index < of ? cell * static_cast<double>(index) : side) - 0.5 * side;
  }
  static constexpr double kMostCells = 1e6;

  /// The wall may cut off the last cell; slivers do not count.
  double cells_in(double side) const { return std::max(1.0, std::ceil(side / cell - 1e-6)); }

  void visit(const elsie::Pose& pose) {
    const double x = pose.x + 0.5 * length_, y = pose.y + 0.5 * width_;
    if (x < 0.0 || x >= length_ || y < 0.0 || y >= width_) {
      return;  // outside of an arena without walls
    }
    const std::size_t rows = visited_.size() / columns_;
    const std::size_t column = std::min(columns_ - 1, static_cast<std::size_t>(x / cell));
    const std::size_t row = std::min(rows - 1, static_cast<std::size_t>(y / cell));
    if (!visited_[row * columns_ + column]) {
      visited_[row * columns_ + column] = true;
      area_ += extent(column, columns_, length_) * extent(row, rows, width_);
    }
  }

  double extent(std::size_t place, std::size_t of, double side) const {
    return place + 1 < of ? cell : side - cell * static_cast<double>(of - 1);
  }

  double length_ = 0.0;
  double width_ = 0.0;
  std::size_t columns_ = 1;
  std::vector<bool> visited_;  // row by row
  double area_ = 0.0;          // m2
};

}  // namespace

ELSIE_MEASURE(Coverage, "coverage", "How much of the arena robots have been in",
              elsie::parameter("cell", &Coverage::cell,
                               {.unit = "m", .above = 0, .meaning = "edge of a cell of the grid"}),
              CHOSEN_ROBOTS_PARAMETERS);

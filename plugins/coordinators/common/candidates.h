// Sets of candidate commands with neighbours.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <elsie/api/motor_command.h>

/// Candidate commands in rows and columns, which have neighbours; and further ones without
/// neighbours.
class Candidates {
 public:
  /// All pairs of wheel rates from -limit to limit, `steps` values each: rows are rates of the left
  /// wheel, columns of the right.
  static Candidates wheel_rates(double limit, int steps);

  /// Arcs: a row for each of `speeds` speeds, in equal steps up to the limit, with `arcs` arcs
  /// each, from a turn to the right in place through straight ahead to a turn to the left in place.
  /// The outer wheel has the speed, the inner one is slower. Standing still is the last candidate.
  static Candidates arcs(double limit, int speeds, int arcs);

  /// Commands without neighbours.
  static Candidates list(std::vector<elsie::MotorCommand> commands);

  std::span<const elsie::MotorCommand> commands() const { return commands_; }
  std::size_t size() const { return commands_.size(); }

  /// Calls `visit(index)` for the neighbours of a candidate in rows, columns and diagonals.
  template <class Visit>
  void each_neighbour(std::size_t index, Visit visit) const {
    if (index >= rows_ * columns_) {
      return;
    }
    const std::size_t row = index / columns_;
    const std::size_t column = index % columns_;
    for (std::size_t r = row > 0 ? row - 1 : 0; r <= row + 1 && r < rows_; ++r) {
      for (std::size_t c = column > 0 ? column - 1 : 0; c <= column + 1 && c < columns_; ++c) {
        if (r != row || c != column) {
          visit(r * columns_ + c);
        }
      }
    }
  }

  /// The command at the tops of parabolas through the values of a candidate and its neighbours, one
  /// along the row and one along the column: at most half a step away. The candidate itself if it
  /// lacks two neighbours or is not higher than these.
  elsie::MotorCommand interpolated(std::size_t index, std::span<const double> values) const;

 private:
  std::vector<elsie::MotorCommand> commands_;
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
};

/// Smooths values over neighbouring candidates: each becomes the mean of all, weighted with a
/// Gaussian of their distance in the plane of wheel rates.
class Smoothing {
 public:
  /// `width`: the standard deviation, rad/s; 0: no smoothing.
  void prepare(std::span<const elsie::MotorCommand> commands, double width);
  void apply(std::span<double> values);

 private:
  struct Neighbour {
    std::size_t index;
    double weight;
  };
  std::vector<Neighbour> neighbours_;  // of all candidates, one after the other
  std::vector<std::size_t> ends_;      // end of each candidate's neighbours
  std::vector<double> raw_;
};

// Sets of candidate commands with neighbours.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <elsie/api/motor_command.h>

/// Candidate commands in rows and columns, so that "the next one" means something; and further ones
/// that have no neighbours.
class Candidates {
 public:
  /// Every pair of wheel rates from -limit to limit, `steps` values each: rows are those of the
  /// left wheel, columns of the right.
  static Candidates wheel_rates(double limit, int steps);

  /// Arcs: a row for each of `speeds` speeds, evenly up to the limit, and in it `arcs` arcs from a
  /// turn to the right in place over straight ahead to one to the left. The outer wheel turns at
  /// the speed, the inner one slower. After them, standing still.
  static Candidates arcs(double limit, int speeds, int arcs);

  /// Commands without neighbours.
  static Candidates list(std::vector<elsie::MotorCommand> commands);

  std::span<const elsie::MotorCommand> commands() const { return commands_; }
  std::size_t size() const { return commands_.size(); }

  /// The candidates next to one in its row and column, diagonals included, through `visit(index)`.
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

  /// The command where parabolas through the values of a candidate and its neighbours, one along
  /// the row and one along the column, have their tops: at most half a step away. The candidate
  /// itself where it has no two neighbours or is not higher than these.
  elsie::MotorCommand interpolated(std::size_t index, std::span<const double> values) const;

 private:
  std::vector<elsie::MotorCommand> commands_;
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
};

/// Values of candidates spread over their neighbourhood: each becomes the mean of all, weighted
/// with a Gaussian of their distance in the plane of wheel rates.
class Smoothing {
 public:
  /// `width`: one standard deviation, rad/s; 0: no smoothing.
  void prepare(std::span<const elsie::MotorCommand> commands, double width);
  void apply(std::span<double> values);

 private:
  struct Neighbour {
    std::size_t index;
    double weight;
  };
  std::vector<Neighbour> neighbours_;  // of one candidate after the other
  std::vector<std::size_t> ends_;      // where each candidate's end
  std::vector<double> raw_;
};

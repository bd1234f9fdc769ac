// Sets of candidate commands with neighbours.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <elsie/api/motion.h>

#include "command_space.h"

/// Candidate commands: some in rows and columns, perhaps in several layers, which have neighbours,
/// and further ones without neighbours.
class Candidates {
 public:
  /// All pairs of wheel rates from -limit to limit, `steps` values each: rows are rates of the left
  /// wheel, columns of the right. For drives with a lateral channel, layers are `laterals` lateral
  /// speeds in the same range.
  static Candidates wheel_rates(const CommandSpace& space, double limit, int steps, int laterals);

  /// Arcs: a row for each of `speeds` speeds, in equal steps up to the limit, with `arcs` arcs
  /// each, from a turn to the right in place through straight ahead to a turn to the left in place.
  /// The outer wheel has the speed, the inner one is slower. Standing still is the last candidate.
  static Candidates arcs(const CommandSpace& space, double limit, int speeds, int arcs);

  /// Commands without neighbours.
  static Candidates list(std::vector<elsie::Motion> commands);

  std::span<const elsie::Motion> commands() const { return commands_; }
  std::size_t size() const { return commands_.size(); }

  /// Calls `visit(index)` for the neighbours of a candidate in rows, columns, layers and diagonals.
  template <class Visit>
  void each_neighbour(std::size_t index, Visit visit) const {
    if (index >= layers_ * rows_ * columns_) {
      return;
    }
    const auto first = [](std::size_t at) { return at > 0 ? at - 1 : 0; };
    const std::size_t layer = index / (rows_ * columns_);
    const std::size_t row = index / columns_ % rows_;
    const std::size_t column = index % columns_;
    for (std::size_t l = first(layer); l <= layer + 1 && l < layers_; ++l) {
      for (std::size_t r = first(row); r <= row + 1 && r < rows_; ++r) {
        for (std::size_t c = first(column); c <= column + 1 && c < columns_; ++c) {
          const std::size_t next = (l * rows_ + r) * columns_ + c;
          if (next != index) {
            visit(next);
          }
        }
      }
    }
  }

  /// The command at the tops of parabolas through the values of a candidate and its neighbours: one
  /// along the row, one along the column and one across the layers. It is at most half a step away.
  /// Returns the candidate itself if it lacks two neighbours or is not higher than these.
  elsie::Motion interpolated(std::size_t index, std::span<const double> values) const;

 private:
  std::vector<elsie::Motion> commands_;
  std::size_t layers_ = 1;
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
};

/// Smooths values over neighbouring candidates: each becomes the mean of all, weighted with a
/// Gaussian of their distance in the space of commands.
class Smoothing {
 public:
  /// `width`: the standard deviation, rad/s; 0: no smoothing.
  void prepare(const CommandSpace& space, std::span<const elsie::Motion> commands, double width);
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

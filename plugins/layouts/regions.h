// Where a scattered thing may stand, and which way it faces.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "described.h"

namespace elsie::layouts {

struct Spot {
  double x = 0.0, y = 0.0;  // m
};

/// The places of one <scatter>'s things.
class Places {
 public:
  /// Adds a problem if the region is not inside of the arena, or has no room for that many places.
  Places(Drawing& drawing, const Scatter& scatter);

  bool is_right() const { return is_right_; }
  /// m2; none for lines and normal distributions, which have no edge.
  std::optional<double> area() const;
  /// Of a grid: how many things there can be.
  std::optional<std::size_t> most() const;
  /// Says how many things there are.
  void expect(std::size_t count) { count_ = count; }

  /// The next place to be tried for the n-th thing; none: all have been tried.
  std::optional<Spot> next(std::size_t thing, int attempt, Random& random);
  /// Rounded as it is written; none: the thing's own.
  std::optional<double> heading_deg(const Spot& spot, Random& random) const;
  /// Says that a thing stands at the place that next() gave.
  void take();

 private:
  bool check(Drawing& drawing);
  bool check_heading(Drawing& drawing) const;

  const Scatter& scatter_;
  Region region_;
  std::size_t count_ = 1;
  // Of a grid: the cells that are free, in random order. The last is tried; where there was no room
  // for one thing, the next one tries last.
  std::deque<std::size_t> cells_;
  bool is_right_ = true;
};

}  // namespace elsie::layouts

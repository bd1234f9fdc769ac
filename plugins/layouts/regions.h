// The places and headings that scattered things may have.
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
  /// The area, m2; none for lines and normal distributions, which have no edge.
  std::optional<double> area() const;
  /// The most things that a grid has room for; none for other regions.
  std::optional<std::size_t> most() const;
  /// Sets the number of things.
  void expect(std::size_t count) { count_ = count; }

  /// The next place to try for the n-th thing; none if all have been tried.
  std::optional<Spot> next(std::size_t thing, int attempt, Random& random);
  /// The heading, rounded as in the file; none if the element keeps its own.
  std::optional<double> heading_deg(const Spot& spot, Random& random) const;
  /// Notes that a thing stands at the place that next() gave.
  void take();

 private:
  bool check(Drawing& drawing);
  bool check_heading(Drawing& drawing) const;

  const Scatter& scatter_;
  Region region_;
  std::size_t count_ = 1;
  // For a grid: the free cells, in random order. The last one is tried; if one thing had no room
  // there, the next thing tries it last.
  std::deque<std::size_t> cells_;
  bool is_right_ = true;
};

}  // namespace elsie::layouts

// Axes: round numbers for the ticks, and the map from values to pixels.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "elsie/api/geometry.h"

namespace elsie::picture {

/// A closed interval; empty at first.
struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  bool empty() const { return !(low <= high); }
  double span() const { return high - low; }
  double part(double value) const { return (value - low) / span(); }
  /// Widens it up to the value; values that are not finite change nothing.
  void include(double value);
  /// The interval, with room added on both sides if it is empty or has a single value.
  Interval widened() const;

  friend bool operator==(const Interval&, const Interval&) = default;
};

/// Positions of ticks and labels on an axis, ascending.
struct Ticks {
  std::vector<double> at;
  double step = 0.0;
  bool powers = false;               // true: they are exponents of ten
  std::vector<std::string> names{};  // their texts, if they are not numbers

  std::string label(double tick) const;
};

/// The step nearest to span / about among 1, 2 and 5 times powers of ten; 1 for a span that is not
/// positive and finite.
double nice_step(double span, int about);

/// The multiples of a step in [low, high]. None for an interval that is empty or not finite.
Ticks multiples(double low, double high, double step);
/// The multiples of a nice step in [low, high], about `about` of them. None for an interval that is
/// empty or not finite.
Ticks nice_ticks(double low, double high, int about);

/// A tick as text, with as many decimals as the step needs and a true minus sign; the same in every
/// locale.
std::string tick_label(double value, double step);

/// The map from the plane of two axes to the picture, in pixels, with x to the right and y down.
struct PlaneMap {
  double scale_x = 1.0;  // pixels per unit
  double scale_y = -1.0;
  double origin_x = 0.0;  // the pixel of (0, 0)
  double origin_y = 0.0;

  Vector2 pixel(const Vector2& point) const {
    return {origin_x + scale_x * point.x, origin_y + scale_y * point.y};
  }
  Vector2 point(const Vector2& pixel) const {
    return {(pixel.x - origin_x) / scale_x, (pixel.y - origin_y) / scale_y};
  }
};

}  // namespace elsie::picture

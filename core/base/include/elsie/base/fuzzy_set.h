// A fuzzy set over one number.
#pragma once

#include <vector>

namespace elsie {

/// A membership function made of straight lines: degrees in [0, 1] at points in ascending order of
/// x, linear in between, constant outside. Two points with the same x make a step. No points: the
/// empty set, zero everywhere.
struct FuzzySet {
  struct Point {
    double x = 0.0;
    double degree = 0.0;

    friend bool operator==(const Point&, const Point&) = default;
  };
  std::vector<Point> points;

  /// The degree at x. At a step, the larger of the two.
  double degree(double x) const;

  /// A triangle with its peak (degree 1) at `centre` that falls to zero at centre +- half_width.
  static FuzzySet triangle(double centre, double half_width);

  friend bool operator==(const FuzzySet&, const FuzzySet&) = default;
};

/// The fuzzy sets behind a behaviour's command, for the wheels of a differential drive: a set for
/// each wheel, rad/s on the x axis. A set without points: no wish for this wheel.
struct CommandSets {
  FuzzySet left;
  FuzzySet right;
  FuzzySet lateral{};  // m/s, to the left; for drives with this channel
};

}  // namespace elsie

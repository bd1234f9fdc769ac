// Consumers of a set that is passed line by line, from left to right: line(x0, x1, y0, y1) with x0
// < x1, degree y0 at x0 and y1 at x1. The set is zero elsewhere.
#pragma once

#include <algorithm>
#include <cmath>

#include "elsie/base/fuzzy_set.h"

namespace elsie::fuzzy {

/// The largest distance of straight lines from the polynomial that they replace.
inline constexpr double kSetTolerance = 2.5e-4;

/// Area and centre of gravity; moments are about a near origin, for precision.
struct CentroidSink {
  explicit CentroidSink(double about) : origin(about) {}

  void line(double x0, double x1, double y0, double y1) {
    const double width = x1 - x0;
    const double piece = 0.5 * (y0 + y1) * width;
    area += piece;
    moment += (x0 - origin) * piece + width * width * (y0 + 2.0 * y1) * (1.0 / 6.0);
  }
  double centroid() const { return origin + moment / area; }

  double origin;
  double area = 0.0;
  double moment = 0.0;
};

/// The x that halves a known area.
struct BisectorSink {
  explicit BisectorSink(double total) : half(0.5 * total), tolerance(1e-12 * total) {}

  void line(double x0, double x1, double y0, double y1) {
    const double piece = 0.5 * (y0 + y1) * (x1 - x0);
    piece_ends(x0, x1, piece, [&](double part) {
      // Solves y0 d + slope d^2 / 2 = part for d.
      const double slope = (y1 - y0) / (x1 - x0);
      const double root = std::sqrt(std::max(0.0, y0 * y0 + 2.0 * slope * part));
      return y0 + root > 0.0 ? std::min(x0 + 2.0 * part / (y0 + root), x1) : x0;
    });
  }

  /// Adds a part of that area; place(part) is the x that limits it.
  template <class Place>
  void piece_ends(double x0, double x1, double piece, Place place) {
    if (piece <= 0.0) {
      return;
    }
    const double before = sum;
    sum += piece;
    if (!reached && sum >= half - tolerance) {
      reached = true;
      reached_x = sum <= half + tolerance ? x1 : place(half - before);
      left_x = reached_x;
    } else if (reached && !left) {
      left_x = x0;
    }
    left = left || (reached && sum > half + tolerance);
  }

  /// If half of the area ends with one island of the set, the middle of the gap to the next.
  double bisector() const { return 0.5 * (reached_x + left_x); }

  double half;
  double tolerance;
  double sum = 0.0;
  bool reached = false;  // half of the area lies left of reached_x
  bool left = false;     // the other half begins at left_x
  double reached_x = 0.0;
  double left_x = 0.0;
};

/// The x at which the set is highest. Degrees that differ by rounding count as equal.
struct MaximaSink {
  void line(double x0, double x1, double y0, double y1) {
    peak(x0, y0);
    peak(x1, y1);
    if (y0 > 0.0 && y1 > 0.0 && is_highest(y0) && is_highest(y1)) {
      plateau_width += x1 - x0;
      plateau_moment += 0.5 * (x1 - x0) * (x0 + x1);
    }
  }

  void peak(double x, double y) {
    if (y > highest * (1.0 + kSame)) {
      *this = MaximaSink();
      highest = y;
    }
    if (y > 0.0 && is_highest(y)) {
      first = peaks == 0 ? x : std::min(first, x);
      // The common peak of two lines counts once.
      if (peaks == 0 || x != last) {
        ++peaks;
        peak_sum += x;
      }
      last = peaks == 1 ? x : std::max(last, x);
    }
  }

  bool is_highest(double y) const { return y >= highest * (1.0 - kSame); }

  double mean() const {
    return plateau_width > 0.0 ? plateau_moment / plateau_width : peak_sum / peaks;
  }

  static constexpr double kSame = 1e-9;
  double highest = 0.0;
  double first = 0.0;
  double last = 0.0;
  double plateau_width = 0.0;
  double plateau_moment = 0.0;
  double peak_sum = 0.0;
  int peaks = 0;
};

/// Collects points of a set in ascending order without redundant ones.
class SetBuilder {
 public:
  explicit SetBuilder(FuzzySet& set) : set_(set) { set_.points.clear(); }

  void point(double x, double y) {
    auto& points = set_.points;
    const std::size_t n = points.size();
    if (n > 0 && points[n - 1].x == x && points[n - 1].degree == y) {
      return;
    }
    if (n > 1) {
      const FuzzySet::Point& a = points[n - 2];
      FuzzySet::Point& b = points[n - 1];
      const bool flat = a.degree == b.degree && b.degree == y;
      const bool within_step = a.x == x && ((a.degree <= b.degree && b.degree <= y) ||
                                            (a.degree >= b.degree && b.degree >= y));
      if (flat || within_step) {
        b = {x, y};
        return;
      }
    }
    points.push_back({x, y});
  }

 private:
  FuzzySet& set_;
};

/// Collects lines as a set over a range.
struct SetSink {
  SetSink(FuzzySet& set, double low, double high) : builder(set), at_(low), high_(high) {}

  void line(double x0, double x1, double y0, double y1) {
    gap(x0);
    builder.point(x0, y0);
    builder.point(x1, y1);
    at_ = x1;
  }
  void finish() { gap(high_); }

  SetBuilder builder;

 private:
  /// The set is zero from where the last line ended.
  void gap(double x) {
    if (x > at_) {
      builder.point(at_, 0.0);
      builder.point(x, 0.0);
    }
  }

  double at_;
  double high_;
};

}  // namespace elsie::fuzzy

#include "elsie/fuzzy/sets.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pieces.h"

namespace elsie::fuzzy {

namespace {

/// Passes the lines of a set to a sink, from its first point to its last.
template <class Sink>
void each_line(const FuzzySet& set, Sink& sink) {
  for (std::size_t i = 0; i + 1 < set.points.size(); ++i) {
    const auto& a = set.points[i];
    const auto& b = set.points[i + 1];
    if (a.x < b.x) {
      sink.line(a.x, b.x, a.degree, b.degree);
    }
  }
}

/// The x of the points of both sets, ascending, each once.
std::vector<double> places(const FuzzySet& a, const FuzzySet& b) {
  std::vector<double> xs;
  for (const FuzzySet* set : {&a, &b}) {
    for (const FuzzySet::Point& point : set->points) {
      xs.push_back(point.x);
    }
  }
  std::sort(xs.begin(), xs.end());
  xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
  return xs;
}

/// Calls stretch(x0, x1, a0, a1, b0, b1) for each stretch on which both sets are straight lines.
/// Spikes have no width; they are drawn at their x.
template <class Combine, class Stretch>
FuzzySet combined(const FuzzySet& a, const FuzzySet& b, Combine combine, Stretch stretch) {
  FuzzySet result;
  const std::vector<double> xs = places(a, b);
  SetBuilder builder(result);
  for (std::size_t i = 0; i < xs.size(); ++i) {
    const double x = xs[i];
    builder.point(x, combine(degree_before(a, x), degree_before(b, x)));
    // The highest degree at x itself shows spikes; at a step it is one of the two sides.
    const double at = combine(a.degree(x), b.degree(x));
    const double before = combine(degree_before(a, x), degree_before(b, x));
    const double after = combine(degree_after(a, x), degree_after(b, x));
    if (at > std::max(before, after)) {
      builder.point(x, at);
    }
    builder.point(x, after);
    if (i + 1 < xs.size()) {
      stretch(builder, x, xs[i + 1], degree_after(a, x), degree_before(a, xs[i + 1]),
              degree_after(b, x), degree_before(b, xs[i + 1]));
    }
  }
  return result;
}

/// The crossing of the lines from a0 to a1 and from b0 to b1, as a fraction of the stretch; outside
/// of (0, 1) if they do not cross.
double crossing(double a0, double a1, double b0, double b1) {
  const double d0 = a0 - b0;
  const double d1 = a1 - b1;
  return (d0 < 0.0) != (d1 < 0.0) && d0 != d1 ? d0 / (d0 - d1) : -1.0;
}

/// For combinations that are straight except where the sets cross.
template <class Combine>
FuzzySet combined_at_crossings(const FuzzySet& a, const FuzzySet& b, Combine combine) {
  return combined(
      a, b, combine,
      [&](SetBuilder& builder, double x0, double x1, double a0, double a1, double b0, double b1) {
        const double t = crossing(a0, a1, b0, b1);
        if (t > 0.0 && t < 1.0) {
          builder.point(x0 + t * (x1 - x0), combine(a0 + t * (a1 - a0), b0 + t * (b1 - b0)));
        }
      });
}

/// For combinations that are parabolas: draws straight lines of equal length within kSetTolerance.
template <class Combine>
FuzzySet combined_parabolas(const FuzzySet& a, const FuzzySet& b, Combine combine) {
  return combined(
      a, b, combine,
      [&](SetBuilder& builder, double x0, double x1, double a0, double a1, double b0, double b1) {
        // A chord over the n-th part is off by |(a1 - a0)(b1 - b0)| / (4 n^2).
        const double bend = std::abs((a1 - a0) * (b1 - b0));
        const int n = std::max(1, static_cast<int>(std::ceil(std::sqrt(bend / kSetTolerance) / 2)));
        for (int i = 1; i < n; ++i) {
          const double t = static_cast<double>(i) / n;
          builder.point(x0 + t * (x1 - x0), combine(a0 + t * (a1 - a0), b0 + t * (b1 - b0)));
        }
      });
}

}  // namespace

double degree_before(const FuzzySet& set, double x) {
  const auto& points = set.points;
  if (points.empty()) {
    return 0.0;
  }
  const auto at = std::lower_bound(points.begin(), points.end(), x,
                                   [](const FuzzySet::Point& p, double v) { return p.x < v; });
  if (at == points.end()) {
    return points.back().degree;
  }
  if (at == points.begin() || at->x == x) {
    return at->degree;
  }
  const auto& left = *(at - 1);
  return left.degree + (at->degree - left.degree) * (x - left.x) / (at->x - left.x);
}

double degree_after(const FuzzySet& set, double x) {
  const auto& points = set.points;
  if (points.empty()) {
    return 0.0;
  }
  const auto right = std::upper_bound(points.begin(), points.end(), x,
                                      [](double v, const FuzzySet::Point& p) { return v < p.x; });
  if (right == points.begin()) {
    return right->degree;
  }
  const auto& left = *(right - 1);
  if (right == points.end() || left.x == x) {
    return left.degree;
  }
  return left.degree + (right->degree - left.degree) * (x - left.x) / (right->x - left.x);
}

double area(const FuzzySet& set) {
  CentroidSink sink(0.0);
  each_line(set, sink);
  return sink.area;
}

double height(const FuzzySet& set) {
  double highest = 0.0;
  for (const FuzzySet::Point& point : set.points) {
    highest = std::max(highest, point.degree);
  }
  return highest;
}

std::optional<double> centroid(const FuzzySet& set) {
  if (set.points.empty()) {
    return std::nullopt;
  }
  CentroidSink sink(0.5 * set.points.front().x + 0.5 * set.points.back().x);
  each_line(set, sink);
  if (!(sink.area > 0.0)) {
    return std::nullopt;
  }
  return std::clamp(sink.centroid(), set.points.front().x, set.points.back().x);
}

std::optional<double> bisector(const FuzzySet& set) {
  const double total = area(set);
  if (!(total > 0.0)) {
    return std::nullopt;
  }
  BisectorSink sink(total);
  each_line(set, sink);
  return sink.bisector();
}

namespace {

std::optional<MaximaSink> maxima(const FuzzySet& set) {
  MaximaSink sink;
  for (std::size_t i = 0; i < set.points.size(); ++i) {
    const auto& point = set.points[i];
    if (i > 0 && set.points[i - 1].x < point.x) {
      sink.line(set.points[i - 1].x, point.x, set.points[i - 1].degree, point.degree);
    } else {
      sink.peak(point.x, point.degree);  // a spike, a step or the first point
    }
  }
  return sink.highest > 0.0 ? std::optional(sink) : std::nullopt;
}

}  // namespace

std::optional<double> leftmost_maximum(const FuzzySet& set) {
  const auto found = maxima(set);
  return found ? std::optional(found->first) : std::nullopt;
}

std::optional<double> rightmost_maximum(const FuzzySet& set) {
  const auto found = maxima(set);
  return found ? std::optional(found->last) : std::nullopt;
}

std::optional<double> mean_of_maxima(const FuzzySet& set) {
  const auto found = maxima(set);
  return found ? std::optional(found->mean()) : std::nullopt;
}

std::optional<double> defuzzify(const FuzzySet& set, Defuzzification method) {
  switch (method) {
    case Defuzzification::centroid:
      return centroid(set);
    case Defuzzification::centroid_of_singletons: {
      double sum = 0.0;
      double moment = 0.0;
      for (const FuzzySet::Point& point : set.points) {
        sum += point.degree;
        moment += point.degree * point.x;
      }
      return sum > 0.0 ? std::optional(moment / sum) : std::nullopt;
    }
    case Defuzzification::bisector:
      return bisector(set);
    case Defuzzification::leftmost_maximum:
      return leftmost_maximum(set);
    case Defuzzification::rightmost_maximum:
      return rightmost_maximum(set);
    case Defuzzification::mean_of_maxima:
      return mean_of_maxima(set);
  }
  return std::nullopt;
}

FuzzySet union_of(const FuzzySet& a, const FuzzySet& b) {
  return combined_at_crossings(a, b, [](double x, double y) { return std::max(x, y); });
}

FuzzySet intersection_of(const FuzzySet& a, const FuzzySet& b) {
  return combined_at_crossings(a, b, [](double x, double y) { return std::min(x, y); });
}

FuzzySet weighted_sum_of(const FuzzySet& a, double weight_a, const FuzzySet& b, double weight_b) {
  return combined(
      a, b, [&](double x, double y) { return weight_a * x + weight_b * y; },
      [](SetBuilder&, double, double, double, double, double, double) {});
}

FuzzySet bounded_sum_of(const FuzzySet& a, const FuzzySet& b) {
  return clipped(weighted_sum_of(a, 1.0, b, 1.0), 1.0);
}

FuzzySet product_of(const FuzzySet& a, const FuzzySet& b) {
  return combined_parabolas(a, b, [](double x, double y) { return x * y; });
}

FuzzySet algebraic_sum_of(const FuzzySet& a, const FuzzySet& b) {
  return combined_parabolas(a, b, [](double x, double y) { return x + y - x * y; });
}

FuzzySet clipped(const FuzzySet& set, double degree) {
  FuzzySet result;
  SetBuilder builder(result);
  for (std::size_t i = 0; i < set.points.size(); ++i) {
    const auto& point = set.points[i];
    if (i > 0) {
      const auto& before = set.points[i - 1];
      const double t = crossing(before.degree, point.degree, degree, degree);
      if (t > 0.0 && t < 1.0) {
        builder.point(before.x + t * (point.x - before.x), degree);
      }
    }
    builder.point(point.x, std::min(point.degree, degree));
  }
  return result;
}

FuzzySet scaled(const FuzzySet& set, double factor) {
  FuzzySet result = set;
  for (FuzzySet::Point& point : result.points) {
    point.degree *= factor;
  }
  return result;
}

FuzzySet complement_of(const FuzzySet& set) {
  if (set.points.empty()) {
    return {{{0.0, 1.0}}};
  }
  FuzzySet result = set;
  for (FuzzySet::Point& point : result.points) {
    point.degree = 1.0 - point.degree;
  }
  return result;
}

FuzzySet restricted(const FuzzySet& set, double low, double high) {
  FuzzySet result;
  if (set.points.empty()) {
    return result;
  }
  SetBuilder builder(result);
  builder.point(low, degree_after(set, low));
  for (const FuzzySet::Point& point : set.points) {
    if (point.x > low && point.x < high) {
      builder.point(point.x, point.degree);
    }
  }
  builder.point(high, degree_before(set, high));
  return result;
}

}  // namespace elsie::fuzzy

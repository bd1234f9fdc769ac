#include "elsie/base/fuzzy_set.h"

#include <algorithm>

namespace elsie {

double FuzzySet::degree(double x) const {
  if (points.empty()) return 0.0;
  // The first point right of x, and the last at or left of it.
  const auto right = std::upper_bound(points.begin(), points.end(), x,
                                      [](double value, const Point& p) { return value < p.x; });
  if (right == points.begin()) return right->degree;
  const Point& left = *(right - 1);
  if (left.x == x) {
    double highest = left.degree;
    for (auto p = right - 1; p != points.begin() && (p - 1)->x == x; --p) {
      highest = std::max(highest, (p - 1)->degree);
    }
    return highest;
  }
  if (right == points.end()) return left.degree;
  return left.degree + (right->degree - left.degree) * (x - left.x) / (right->x - left.x);
}

FuzzySet FuzzySet::triangle(double centre, double half_width) {
  return {{{centre - half_width, 0.0}, {centre, 1.0}, {centre + half_width, 0.0}}};
}

}  // namespace elsie

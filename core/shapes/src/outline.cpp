#include "elsie/shapes/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "elsie/base/number_text.h"
#include "elsie/base/words.h"

namespace elsie {
namespace {

using base::number_text;

Vector2 operator-(const Vector2& a, const Vector2& b) { return {a.x - b.x, a.y - b.y}; }
double cross(const Vector2& a, const Vector2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

std::optional<std::string> problem_of_outline(Corners points, const char* things) {
  const std::size_t n = points.size();
  if (n < 3 || n > 16) {
    return "has " + base::counted(n, "point") + "; expected 3 to 16 points around its outline";
  }
  const auto nth = [&](std::size_t i) { return points[i % n]; };
  const auto point = [&](std::size_t i) {
    return "its point " + std::to_string(i % n + 1) + " at (" + number_text(nth(i).x) + ", " +
           number_text(nth(i).y) + ")";
  };
  double around = 0.0, turned = 0.0;
  std::vector<double> turns;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2 edge = nth(i + 1) - nth(i), next = nth(i + 2) - nth(i + 1);
    const double length = std::hypot(edge.x, edge.y);
    if (length < kLeastLength) {
      return "has " + point(i + 1) + " where the one before it is; take it out";
    }
    around += length;
    turned += turns.emplace_back(std::atan2(cross(edge, next), edge.x * next.x + edge.y * next.y));
  }
  const double area = area_of(points);
  if (std::abs(std::abs(turned) - 2.0 * std::numbers::pi) > 1e-6 ||
      std::abs(area) < 0.5 * kLeastLength * around) {
    return "has an outline without area, or one that crosses itself; expected points in the order "
           "in which they go around it";
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (std::copysign(turns[i], turns[i] * area) < -1e-9) {
      return "is not convex: its outline turns inwards at " + point(i + 1) + "; make several " +
             things + " of it";
    }
  }
  return std::nullopt;
}

double area_of(Corners corners) {
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    twice += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  return 0.5 * twice;
}

std::vector<Vector2> centered_outline(Corners points) {
  std::vector<Vector2> corners(points.begin(), points.end());
  const double area = area_of(points);
  if (area < 0.0) std::reverse(corners.begin(), corners.end());
  Vector2 center = corners[0];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Vector2 a = corners[i] - corners[0], b = corners[i + 1] - corners[0];
    const double part = cross(a, b) / (6.0 * std::abs(area));
    center = {center.x + part * (a.x + b.x), center.y + part * (a.y + b.y)};
  }
  for (Vector2& corner : corners) corner = corner - center;
  return corners;
}

OutlineMoments moments_of(Corners corners) {
  OutlineMoments sum;
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2 &a = corners[i], &b = corners[i + 1 < corners.size() ? i + 1 : 0];
    const double cross = a.x * b.y - b.x * a.y;
    area += 0.5 * cross;
    sum.xx += cross * (a.x * a.x + a.x * b.x + b.x * b.x) / 12.0;
    sum.yy += cross * (a.y * a.y + a.y * b.y + b.y * b.y) / 12.0;
    sum.xy += cross * (2.0 * a.x * a.y + a.x * b.y + b.x * a.y + 2.0 * b.x * b.y) / 24.0;
  }
  return {sum.xx / area, sum.yy / area, sum.xy / area};
}

}  // namespace elsie

#include "elsie/picture/polyline.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace elsie::picture {

namespace {

// The distance of a point from the line segment between two others.
double distance(const Vector2& p, const Vector2& a, const Vector2& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double squared = dx * dx + dy * dy;
  const double part =
      squared > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - part * dx, p.y - a.y - part * dy);
}

}  // namespace

std::vector<Vector2> simplified(const std::vector<Vector2>& line, double tolerance) {
  if (line.size() < 3) return line;
  std::vector<bool> kept(line.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    double farthest = tolerance;
    std::size_t split = 0;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double d = distance(line[i], line[from], line[to]);
      if (d > farthest) farthest = d, split = i;
    }
    if (split == 0) continue;
    kept[split] = true;
    open.emplace_back(from, split);
    open.emplace_back(split, to);
  }
  std::vector<Vector2> result;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (kept[i]) result.push_back(line[i]);
  }
  return result;
}

std::vector<std::vector<Vector2>> pieces(const std::vector<Vector2>& line) {
  std::vector<std::vector<Vector2>> result(1);
  for (const Vector2& point : line) {
    if (std::isfinite(point.x) && std::isfinite(point.y)) {
      result.back().push_back(point);
    } else if (!result.back().empty()) {
      result.emplace_back();
    }
  }
  if (result.back().empty()) result.pop_back();
  return result;
}

}  // namespace elsie::picture

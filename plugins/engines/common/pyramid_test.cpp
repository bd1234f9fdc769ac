#include "pyramid_test.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace elsie::physics {
namespace {

Vector3 normalized(const Vector3& v) {
  const double length = std::sqrt(dot(v, v));
  return length > 0.0 ? (1.0 / length) * v : v;
}

}  // namespace

/// The corners and the cut edges of a pyramid, seen along an axis.
class Shadow {
 public:
  void add(const Vector2& point) { points_[count_++] = point; }

  /// True if their convex hull comes within this distance of the origin.
  bool comes_within(double radius) {
    const auto corners = static_cast<std::ptrdiff_t>(hull());
    if (corners == 0) return false;
    bool is_inside = corners > 2;
    for (std::ptrdiff_t i = 0; i < corners; ++i) {
      const Vector2& from = hull_[static_cast<std::size_t>(i)];
      const Vector2& to = hull_[static_cast<std::size_t>((i + 1) % corners)];
      if (distance_to_edge(from, to) <= radius) return true;
      is_inside = is_inside && from.x * to.y - from.y * to.x >= 0.0;
    }
    return is_inside;
  }

  /// True if their convex hull and the outline have a point in common (separating axes).
  bool meets(Corners outline) {
    const std::span<const Vector2> corners(hull_.data(), hull());
    return !corners.empty() && !is_in_front(outline, corners) && !is_in_front(corners, outline);
  }

 private:
  /// True if one of an outline's sides has all other corners in front of it.
  static bool is_in_front(Corners outline, Corners others) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vector2 &from = outline[i], &to = outline[(i + 1) % outline.size()];
      if (std::all_of(others.begin(), others.end(),
                      [&](const Vector2& other) { return turn(from, to, other) < 0.0; })) {
        return true;
      }
    }
    return false;
  }

  static constexpr std::size_t kMost = 5 + 2 * 8;  // corners, and edges cut by two planes

  /// Its corners, counter-clockwise (monotone chain, Andrew 1979); returns their number.
  std::size_t hull() {
    const auto end = points_.begin() + static_cast<std::ptrdiff_t>(count_);
    std::sort(points_.begin(), end, [](const Vector2& a, const Vector2& b) {
      return a.x != b.x ? a.x < b.x : a.y < b.y;
    });
    if (count_ < 3) {
      std::copy(points_.begin(), end, hull_.begin());
      return count_;
    }
    std::size_t size = 0;
    const auto extend = [&](const Vector2& point, std::size_t least) {
      while (size >= least && turn(hull_[size - 2], hull_[size - 1], point) <= 0.0) --size;
      hull_[size++] = point;
    };
    for (std::size_t i = 0; i < count_; ++i) extend(points_[i], 2);
    const std::size_t least = size + 1;
    for (std::size_t i = count_ - 1; i-- > 0;) extend(points_[i], least);
    return size - 1;  // the last one is the first
  }

  static double turn(const Vector2& a, const Vector2& b, const Vector2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }

  static double distance_to_edge(const Vector2& from, const Vector2& to) {
    const Vector2 edge{to.x - from.x, to.y - from.y};
    const double square = edge.x * edge.x + edge.y * edge.y;
    const double along = -(from.x * edge.x + from.y * edge.y);
    const double part = square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
    return std::hypot(from.x + part * edge.x, from.y + part * edge.y);
  }

  std::array<Vector2, kMost> points_;
  std::array<Vector2, 2 * kMost> hull_;
  std::size_t count_ = 0;
};

PyramidTest::PyramidTest(const Pyramid& pyramid) {
  const Frame& frame = pyramid.frame;
  const double across = std::tan(0.5 * pyramid.horizontal_fov_rad);
  const double upward = std::tan(0.5 * pyramid.vertical_fov_rad);
  // Directions to the corners, around the axis.
  const std::array<Vector3, 4> corners{
      frame.direction({1.0, across, upward}), frame.direction({1.0, -across, upward}),
      frame.direction({1.0, -across, -upward}), frame.direction({1.0, across, -upward})};
  points_[0] = frame.origin;
  for (std::size_t i = 0; i < 4; ++i) {
    points_[i + 1] = frame.origin + pyramid.range_m * corners[i];
    normals_[i] = normalized(cross(corners[i], corners[(i + 1) % 4]));
    edges_[i] = normalized(corners[i]);
  }
  normals_[4] = frame.forward;
  edges_[4] = frame.left;
  edges_[5] = frame.up;

  bounds_ = {points_[0], points_[0]};
  for (const Vector3& p : points_) {
    bounds_.lower = {std::min(bounds_.lower.x, p.x), std::min(bounds_.lower.y, p.y),
                     std::min(bounds_.lower.z, p.z)};
    bounds_.upper = {std::max(bounds_.upper.x, p.x), std::max(bounds_.upper.y, p.y),
                     std::max(bounds_.upper.z, p.z)};
  }
}

bool PyramidTest::separated_along(const Vector3& axis, const OrientedBox& box) const {
  double least = dot(axis, points_[0] - box.center), most = least;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const double along = dot(axis, points_[i] - box.center);
    least = std::min(least, along);
    most = std::max(most, along);
  }
  const double extent = box.half.x * std::abs(dot(axis, box.axes[0])) +
                        box.half.y * std::abs(dot(axis, box.axes[1])) +
                        box.half.z * std::abs(dot(axis, box.axes[2]));
  return least > extent || most < -extent;
}

bool PyramidTest::meets(const OrientedBox& box) const {
  for (const Vector3& normal : normals_) {
    if (separated_along(normal, box)) return false;
  }
  for (const Vector3& axis : box.axes) {
    if (separated_along(axis, box)) return false;
  }
  for (const Vector3& edge : edges_) {
    for (const Vector3& axis : box.axes) {
      const Vector3 both = cross(edge, axis);
      // Parallel edges span no plane; the faces have been tried.
      if (dot(both, both) > 1e-12 && separated_along(both, box)) return false;
    }
  }
  return true;
}

bool PyramidTest::meets(const Cylinder& cylinder) const {
  const Vector3& axis = cylinder.axis;
  const Vector3 other = std::abs(axis.z) < 0.5 ? Vector3{0.0, 0.0, 1.0} : Vector3{1.0, 0.0, 0.0};
  const Vector3 u = normalized(cross(other, axis)), v = cross(axis, u);
  return shadow(cylinder.center, {u, v, axis}, cylinder.half_length).comes_within(cylinder.radius);
}

bool PyramidTest::meets(const OrientedBox& box, Corners outline) const {
  return shadow(box.center, box.axes, box.half.z).meets(outline);
}

Shadow PyramidTest::shadow(const Vector3& center, const std::array<Vector3, 3>& axes,
                           double half_height) const {
  std::array<double, 5> along{};
  std::array<Vector2, 5> across;
  Shadow shadow;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vector3 at = points_[i] - center;
    along[i] = dot(axes[2], at);
    across[i] = {dot(axes[0], at), dot(axes[1], at)};
    if (std::abs(along[i]) <= half_height) shadow.add(across[i]);
  }
  const auto cut = [&](std::size_t i, std::size_t j) {
    for (const double plane : {-half_height, half_height}) {
      const double from = along[i] - plane, to = along[j] - plane;
      if (!(from * to < 0.0)) continue;
      const double part = from / (from - to);
      shadow.add({across[i].x + part * (across[j].x - across[i].x),
                  across[i].y + part * (across[j].y - across[i].y)});
    }
  };
  for (std::size_t corner = 1; corner <= 4; ++corner) {
    cut(0, corner);
    cut(corner, corner % 4 + 1);
  }
  return shadow;
}

}  // namespace elsie::physics

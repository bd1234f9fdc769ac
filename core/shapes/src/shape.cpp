#include "elsie/shapes/shape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "elsie/shapes/outline.h"

namespace elsie {
namespace {

/// Moments about an axis of the frame, and across it.
Vector3 about(Shape::Axis axis, double along, double across) {
  return {axis == Shape::Axis::forward ? along : across, axis == Shape::Axis::left ? along : across,
          axis == Shape::Axis::up ? along : across};
}

}  // namespace

Shape Shape::prism(std::vector<Vector2> outline, double height) {
  Vector3 size{0.0, 0.0, height};
  for (const Vector2& corner : outline) {
    size.x = std::max(size.x, 2.0 * std::abs(corner.x));
    size.y = std::max(size.y, 2.0 * std::abs(corner.y));
  }
  return {Kind::prism, size, Axis::up, std::move(outline)};
}

Frame along_axis(const Frame& frame, Shape::Axis axis) {
  const auto& [origin, forward, left, up] = frame;
  switch (axis) {
    case Shape::Axis::forward:
      return {origin, -1.0 * up, left, forward};
    case Shape::Axis::left:
      return {origin, forward, -1.0 * up, left};
    default:
      return frame;
  }
}

bool is_sound(const Shape& shape) {
  const std::array sizes{shape.size.x, shape.size.y, shape.size.z};
  if (!std::all_of(sizes.begin(), sizes.end(),
                   [](double size) { return std::isfinite(size) && size > 0.0; })) {
    return false;
  }
  const auto axis = static_cast<std::size_t>(shape.axis);
  const double across = sizes[(axis + 1) % 3], along = sizes[axis];
  const bool is_even = sizes[(axis + 2) % 3] == across;
  switch (shape.kind) {
    case Shape::Kind::box:
      return true;
    case Shape::Kind::cylinder:
      return is_even;
    case Shape::Kind::sphere:
      return is_even && along == across;
    case Shape::Kind::capsule:
      return is_even && along >= across;
    case Shape::Kind::prism:
      return !problem_of_outline(shape.outline);
  }
  return false;
}

std::vector<Piece> pieces_of(const Shape& shape, const Frame& middle) {
  const Frame along = along_axis(middle, shape.axis);
  const double radius = shape.radius(), between = shape.length() - 2.0 * radius;
  const auto ball = [&](double end) {
    return Piece{Shape::sphere(radius), {.origin = along.point({0.0, 0.0, end * between})}};
  };
  switch (shape.kind) {
    case Shape::Kind::cylinder:
      return {{Shape::pillar(radius, shape.length()), along}};
    case Shape::Kind::sphere:
      return {{shape, {.origin = middle.origin}}};
    case Shape::Kind::capsule:
      return {{Shape::pillar(radius, between), along}, ball(0.5), ball(-0.5)};
    default:
      return {{shape, middle}};
  }
}

std::vector<Vector2> outline_of(const Shape& shape, int sides) {
  const double x = 0.5 * shape.size.x, y = 0.5 * shape.size.y;
  if (!shape.outline.empty()) return shape.outline;
  if (!shape.is_round()) return {{x, y}, {-x, y}, {-x, -y}, {x, -y}};
  std::vector<Vector2> corners;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / sides;
    corners.push_back({x * std::cos(angle), x * std::sin(angle)});
  }
  return corners;
}

Shape resized(const Shape& shape, double length, double width) {
  Shape made = shape;
  const double x = shape.size.x, y = shape.size.y;
  made.size = {length, width, shape.size.z};
  if (shape.is_round()) {
    made.size.x = made.size.y = std::abs(length - x) > std::abs(width - y) ? length : width;
  }
  for (Vector2& corner : made.outline) corner = {corner.x * length / x, corner.y * width / y};
  return made;
}

Vector3 inertia_of(const Shape& shape, double mass) {
  const double m = mass, r = shape.radius(), l = shape.length();
  switch (shape.kind) {
    case Shape::Kind::cylinder:
      return about(shape.axis, 0.5 * m * r * r, m * (3.0 * r * r + l * l) / 12.0);
    case Shape::Kind::sphere:
      return about(shape.axis, 0.4 * m * r * r, 0.4 * m * r * r);
    case Shape::Kind::capsule: {
      // A cylinder between two half balls, whose centers of mass are 3/8 r away from it.
      const double h = l - 2.0 * r;
      const double balls = m * 4.0 * r / (3.0 * h + 4.0 * r), between = m - balls;
      return about(shape.axis, (0.5 * between + 0.4 * balls) * r * r,
                   between * (3.0 * r * r + h * h) / 12.0 +
                       balls * (0.4 * r * r + 0.25 * h * h + 0.375 * h * r));
    }
    case Shape::Kind::prism: {
      const OutlineMoments area = moments_of(shape.outline);
      const double upright = shape.size.z * shape.size.z / 12.0;
      return {m * (area.yy + upright), m * (area.xx + upright), m * (area.xx + area.yy)};
    }
    default: {
      const Vector3& size = shape.size;
      const double x = size.x * size.x, y = size.y * size.y, z = size.z * size.z;
      const double sum = x + y + z;
      return {m / 12.0 * (sum - x), m / 12.0 * (sum - y), m / 12.0 * (sum - z)};
    }
  }
}

double upright_inertia_of(const Shape& shape, double mass) {
  if (shape.kind != Shape::Kind::box) return inertia_of(shape, mass).z;
  return mass / 12.0 * (shape.size.x * shape.size.x + shape.size.y * shape.size.y);
}

double spread_of(const Shape& shape) {
  if (shape.kind != Shape::Kind::box) return inertia_of(shape, 1.0).z;
  return (shape.size.x * shape.size.x + shape.size.y * shape.size.y) / 12.0;
}

}  // namespace elsie

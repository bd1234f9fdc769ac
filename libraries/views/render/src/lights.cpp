#include "lights.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace elsie::render {
namespace {

constexpr double kSunRadius = 0.07;  // rad, large enough for soft shadows

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Vector3 unit(const Vector3& v) { return (1.0 / std::sqrt(dot(v, v))) * v; }

struct Axes {
  Vector3 across, aside;
};
Axes axes_around(const Vector3& direction) {
  const Vector3 across =
      unit(cross(std::abs(direction.z) < 0.9 ? Vector3{0, 0, 1} : Vector3{1, 0, 0}, direction));
  return {across, cross(direction, across)};
}

}  // namespace

// Behind the viewer's left shoulder if she looks north, so that what she sees of things is lit.
const Vector3 kSunDirection = unit({-0.42, -0.36, 0.83});

Vector2 spread(int index, double shift) {
  const auto part = [&](double step) {
    const double at = shift + step * index;
    return at - std::floor(at);
  };
  return {part(0.7548776662466927), part(0.5698402909980532)};
}

Vector3 sun_at(int pass) {
  if (pass == 0) return kSunDirection;
  const Vector2 at = spread(pass);
  const double away = kSunRadius * std::sqrt(at.x), round = 2.0 * std::numbers::pi * at.y;
  const Axes axes = axes_around(kSunDirection);
  return unit(kSunDirection + away * std::cos(round) * axes.across +
              away * std::sin(round) * axes.aside);
}

Vector3 dome_at(int pass) {
  const Vector2 at = spread(pass, 0.31);
  const double up = std::sqrt(1.0 - 0.85 * at.x), round = 2.0 * std::numbers::pi * at.y;
  const double aside = std::sqrt(1.0 - up * up);
  return {aside * std::cos(round), aside * std::sin(round), up};
}

double Room::widest() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }

Matrix light_matrix(const Room& room, const Vector3& direction) {
  const auto& [low, high] = room;
  const auto [across, aside] = axes_around(direction);
  const Vector3 rows[] = {across, aside, -1.0 * direction};
  Matrix matrix{};
  matrix[15] = 1.0F;
  for (int row = 0; row < 3; ++row) {
    double least = 1e300, most = -1e300;
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3 at{corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y,
                       corner & 4 ? high.z : low.z};
      least = std::min(least, dot(rows[row], at));
      most = std::max(most, dot(rows[row], at));
    }
    const double scale = 1.98 / std::max(1e-3, most - least), middle = 0.5 * (least + most);
    matrix[static_cast<std::size_t>(row)] = static_cast<float>(scale * rows[row].x);
    matrix[static_cast<std::size_t>(row) + 4] = static_cast<float>(scale * rows[row].y);
    matrix[static_cast<std::size_t>(row) + 8] = static_cast<float>(scale * rows[row].z);
    matrix[static_cast<std::size_t>(row) + 12] = static_cast<float>(-scale * middle);
  }
  return matrix;
}

Matrix as_texture(Matrix matrix) {
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      matrix[4 * column + row] = 0.5F * matrix[4 * column + row] + 0.5F * matrix[4 * column + 3];
    }
  }
  return matrix;
}

}  // namespace elsie::render

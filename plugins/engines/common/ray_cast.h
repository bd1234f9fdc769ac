// The nearest body along a ray, among those in the cells of a grid.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "elsie/base/grid.h"
#include "elsie/physics/engine.h"

#include "ray_tests.h"

namespace elsie::physics {

/// Engine::cast_rays(), one after the other. `cast_ray`: as Engine::cast_ray().
template <class CastRay>
void cast_each(const Frame& within, std::span<RayQuery> rays, CastRay cast_ray) {
  for (RayQuery& ray : rays) {
    const auto hit = cast_ray(within.point(ray.from->origin), within.direction(ray.from->forward),
                              ray.max_range_m);
    ray.distance_m = hit ? hit->distance : RayQuery::kNothing;
  }
}

/// Engine::cast_ray() over the grid's cells along the ray (Amanatides and Woo, "A fast voxel
/// traversal algorithm", 1987). `distance_to(id, ray, range)`: where the ray meets a body, m; more
/// than the range, or kMiss, where it does not.
template <class DistanceTo, class BodyOf>
std::optional<RayHit> cast_ray(const base::Grid& grid, const Vector3& origin,
                               const Vector3& direction, double max_range, DistanceTo distance_to,
                               BodyOf body_of) {
  if (!std::isfinite(dot(origin, origin) + dot(direction, direction))) return std::nullopt;
  const Ray ray(origin, direction);
  RayHit best;
  best.distance = max_range;
  bool found = false;
  if (direction.z < 0.0) {
    // The floor is seen from above; a ray from below hits it at once.
    const double distance = std::max(0.0, -origin.z / direction.z);
    if (distance <= max_range) {
      best = {distance, {}, true};
      found = true;
    }
  }

  int x = grid.column(origin.x), y = grid.row(origin.y);
  const int step_x = direction.x > 0.0 ? 1 : -1, step_y = direction.y > 0.0 ? 1 : -1;
  const auto leave_column = [&] {
    if (direction.x == 0.0 || (step_x > 0 ? x + 1 >= grid.columns() : x == 0)) return kMiss;
    return (grid.column_border(step_x > 0 ? x + 1 : x) - origin.x) * ray.inverse.x;
  };
  const auto leave_row = [&] {
    if (direction.y == 0.0 || (step_y > 0 ? y + 1 >= grid.rows() : y == 0)) return kMiss;
    return (grid.row_border(step_y > 0 ? y + 1 : y) - origin.y) * ray.inverse.y;
  };
  double at_column_end = leave_column(), at_row_end = leave_row();
  while (true) {
    for (const base::Grid::Id id : grid.cell(x, y)) {
      const double distance = distance_to(id, ray, best.distance);
      if (distance == kMiss || distance > best.distance) continue;
      if (distance < best.distance || !found || best.floor || body_of(id) < best.body) {
        best = {distance, body_of(id), false};
        found = true;
      }
    }
    if (best.distance <= std::min(at_column_end, at_row_end)) break;
    if (at_column_end < at_row_end) {
      x += step_x;
      at_column_end = leave_column();
    } else {
      y += step_y;
      at_row_end = leave_row();
    }
  }
  return found ? std::optional(best) : std::nullopt;
}

}  // namespace elsie::physics

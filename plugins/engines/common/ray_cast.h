// The nearest body along a ray, among those in the cells of a grid.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>

#include "elsie/base/grid.h"
#include "elsie/physics/engine.h"

#include "ray_tests.h"

namespace elsie::physics {

// The functions below ask a `View`: the bodies of an engine as the rays of one robot meet them.
//
//   bool sees(id) const;                                whether rays meet the body
//   double distance_to(id, ray, range) const;           where a ray meets a body that is seen, m;
//                                                       more than the range, or kMiss: it does not
//   Vector3 normal_of(id, ray) const;                   the normal there
//   Body body_of(id) const;
//   const base::Grid& grid() const;                     which lists the bodies,
//   base::Grid::Block block_of(id) const;               each in these cells
//   Reach reach_of(id) const;                           the rectangle around a body

/// A rectangle over the floor that encloses a body, m.
struct Reach {
  Vector2 least, most;
};

/// The nearest that a ray has met so far.
struct Nearest {
  double distance = 0.0;  // m; the range, before it meets anything
  base::Grid::Id id = 0;  // of a body
  bool found = false;
  bool floor = false;

  /// The floor is seen from above; a ray from below hits it at once.
  void meet_floor(const Ray& ray) {
    if (!(ray.direction.z < 0.0)) return;
    const double there = std::max(0.0, -ray.origin.z / ray.direction.z);
    if (there <= distance) *this = {there, 0, true, true};
  }
  /// Of bodies at the same distance, the first in their order is hit, and none below the floor.
  template <class View>
  void meet(const View& view, base::Grid::Id body, const Ray& ray) {
    const double there = view.distance_to(body, ray, distance);
    if (there == kMiss || there > distance) return;
    if (there == distance && found && !floor && !(view.body_of(body) < view.body_of(id))) return;
    *this = {there, body, true, false};
  }
};

inline bool is_finite(const Ray& ray) {
  return std::isfinite(dot(ray.origin, ray.origin) + dot(ray.direction, ray.direction));
}

/// Over the grid's cells along the ray (Amanatides and Woo, "A fast voxel traversal algorithm",
/// 1987).
template <class View>
Nearest cast(const View& view, const Ray& ray, double max_range) {
  Nearest nearest;
  nearest.distance = max_range;
  if (!is_finite(ray)) return nearest;
  nearest.meet_floor(ray);

  const base::Grid& grid = view.grid();
  const Vector3 &origin = ray.origin, &direction = ray.direction;
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
      if (view.sees(id)) nearest.meet(view, id, ray);
    }
    if (nearest.distance <= std::min(at_column_end, at_row_end)) break;
    if (at_column_end < at_row_end) {
      x += step_x;
      at_column_end = leave_column();
    } else {
      y += step_y;
      at_row_end = leave_row();
    }
  }
  return nearest;
}

/// As Engine::cast_ray().
template <class View>
std::optional<RayHit> cast_ray(const View& view, const Vector3& origin, const Vector3& direction,
                               double max_range) {
  const Nearest nearest = cast(view, Ray(origin, direction), max_range);
  if (!nearest.found) return std::nullopt;
  if (nearest.floor) return RayHit{nearest.distance, {}, true};
  return RayHit{nearest.distance, view.body_of(nearest.id), false};
}

inline Surface::Kind kind_of(BodyKind kind) {
  return kind == BodyKind::wall       ? Surface::Kind::wall
         : kind == BodyKind::obstacle ? Surface::Kind::obstacle
                                      : Surface::Kind::robot;
}

template <class View>
Surface surface_of(const View& view, const Nearest& nearest, const Ray& ray) {
  if (!nearest.found) return {};
  if (nearest.floor) {
    const bool is_above = ray.origin.z > 0.0;
    return {Surface::Kind::floor, 0, is_above ? Vector3{0.0, 0.0, 1.0} : -1.0 * ray.direction};
  }
  const Body body = view.body_of(nearest.id);
  return {kind_of(body.kind), body.index, view.normal_of(nearest.id, ray)};
}

inline double answer_of(const Nearest& nearest) {
  return nearest.found ? nearest.distance : RayQuery::kNothing;
}

inline void check_surfaces(std::span<const RayQuery> rays, std::span<const Surface> surfaces) {
  if (surfaces.empty() || surfaces.size() == rays.size()) return;
  throw std::invalid_argument("There must be a surface for each ray, or none.");
}

/// Engine::cast_rays(), one after the other.
template <class View>
void cast_each(const View& view, const Frame& within, std::span<RayQuery> rays,
               std::span<Surface> surfaces) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    RayQuery& query = rays[i];
    const Ray ray(within.point(query.from->origin), within.direction(query.from->forward));
    const Nearest nearest = cast(view, ray, query.max_range_m);
    query.distance_m = answer_of(nearest);
    if (!surfaces.empty()) surfaces[i] = surface_of(view, nearest, ray);
  }
}

}  // namespace elsie::physics

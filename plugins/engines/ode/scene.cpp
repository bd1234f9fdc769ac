#include "scene.h"

#include <algorithm>
#include <cmath>

namespace elsie::physics {
namespace {

constexpr double kHair = 1e-9;  // m

OrientedBox box_around(const Cylinder& wheel, const OrientedBox& chassis) {
  const Vector3& up = chassis.axes[2];
  return {wheel.center,
          {cross(wheel.axis, up), wheel.axis, up},
          {wheel.radius, wheel.half_length, wheel.radius}};
}

base::Grid::Block cells(const base::Grid& grid, const Aabb& bounds) {
  return grid.block(bounds.lower.x, bounds.lower.y, bounds.upper.x, bounds.upper.y);
}

}  // namespace

Scene::Scene(const world::Arena& arena) : grid_(arena.length, arena.width) {}

Scene::Id Scene::add(Body body, bool sensed, std::size_t part) {
  Entry entry;
  entry.body = body;
  entry.part = part;
  entry.sensed = sensed;
  entry.is_robot = body.kind == BodyKind::robot;
  entries_.push_back(entry);
  return static_cast<Id>(entries_.size() - 1);
}

bool Scene::place(Id id, const Aabb& bounds, double reach) {
  Entry& entry = entries_[id];
  entry.bounds = bounds.grown(kHair);
  entry.reach = reach;
  entry.next = cells(grid_, entry.bounds.grown(reach));
  return !entry.placed || entry.next != entry.block;
}

void Scene::enter(Id id) {
  Entry& entry = entries_[id];
  if (entry.placed) grid_.erase(id, entry.block);
  grid_.insert(id, entry.next);
  entry.block = entry.next;
  entry.placed = true;
}

void Scene::place_box(Id id, const OrientedBox& box, double reach) {
  entries_[id].solid.put(box);
  if (place(id, bounds(box), reach)) enter(id);
}

bool Scene::place_robot(Id id, const SensedSolid& sensed, const std::vector<Cylinder>& wheels,
                        const Aabb& enclosing, double reach) {
  Entry& entry = entries_[id];
  entry.solid = sensed;
  entry.wheels = wheels;
  entry.wheels_top = 0.0;
  for (const Cylinder& wheel : wheels) {
    entry.wheels_top =
        std::max(entry.wheels_top, wheel.center.z + wheel.radius + wheel.half_length);
  }
  return place(id, enclosing, reach);
}

void Scene::remove(Id id) {
  Entry& entry = entries_[id];
  if (entry.placed) grid_.erase(id, entry.block);
  entry.placed = false;
}

void Scene::neighbors(Id id, std::vector<Id>& found) const {
  found.clear();
  const Entry& self = entries_[id];
  for (int y = self.block.y0; y <= self.block.y1; ++y) {
    for (int x = self.block.x0; x <= self.block.x1; ++x) {
      for (const Id other : grid_.cell(x, y)) {
        const Entry& entry = entries_[other];
        if (other != id && entry.bounds.overlaps(self.bounds, self.reach + entry.reach)) {
          found.push_back(other);
        }
      }
    }
  }
  if (found.size() < 2) return;
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

std::optional<RayHit> Scene::cast_ray(const Vector3& origin, const Vector3& direction,
                                      double max_range, std::size_t except) const {
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

  // From cell to cell along the ray (Amanatides and Woo 1987).
  int x = grid_.column(origin.x), y = grid_.row(origin.y);
  const int step_x = direction.x > 0.0 ? 1 : -1, step_y = direction.y > 0.0 ? 1 : -1;
  const auto leave_column = [&] {
    if (direction.x == 0.0 || (step_x > 0 ? x + 1 >= grid_.columns() : x == 0)) return kMiss;
    return (grid_.column_border(step_x > 0 ? x + 1 : x) - origin.x) * ray.inverse.x;
  };
  const auto leave_row = [&] {
    if (direction.y == 0.0 || (step_y > 0 ? y + 1 >= grid_.rows() : y == 0)) return kMiss;
    return (grid_.row_border(step_y > 0 ? y + 1 : y) - origin.y) * ray.inverse.y;
  };
  double at_column_end = leave_column(), at_row_end = leave_row();
  while (true) {
    for (const Id id : grid_.cell(x, y)) {
      const Entry& entry = entries_[id];
      if (!is_seen(entry, except) || !meets_bounds(ray, entry.bounds, best.distance)) continue;
      const double distance = distance_to(ray, entry.solid, entry.wheels, entry.wheels_top);
      if (distance > best.distance) continue;
      const bool wins = distance < best.distance || !found || best.floor || entry.body < best.body;
      if (!wins) continue;
      best = {distance, entry.body, false};
      found = true;
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

bool Scene::anything_in(const Pyramid& pyramid, std::size_t except) const {
  if (!(pyramid.range_m > 0.0)) return false;
  const PyramidTest test(pyramid);
  const base::Grid::Block block = cells(grid_, test.bounds());
  for (int y = block.y0; y <= block.y1; ++y) {
    for (int x = block.x0; x <= block.x1; ++x) {
      for (const Id id : grid_.cell(x, y)) {
        const Entry& entry = entries_[id];
        if (!is_seen(entry, except) || !entry.bounds.overlaps(test.bounds(), 0.0)) continue;
        if (is_in(test, entry.solid)) return true;
        const auto is_met = [&](const Cylinder& wheel) {
          return test.meets(box_around(wheel, entry.solid.box));
        };
        if (std::any_of(entry.wheels.begin(), entry.wheels.end(), is_met)) return true;
      }
    }
  }
  return false;
}

}  // namespace elsie::physics

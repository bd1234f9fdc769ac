#include "scene.h"

#include <algorithm>

#include "ray_cast.h"
#include "ray_fan.h"
#include "surface_normals.h"

namespace elsie::physics {
namespace {

constexpr double kHair = 1e-9;  // m

// Fewer rays from one point are cast one by one.
constexpr std::size_t kLeastFan = 32;

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

/// See ray_cast.h.
class Scene::View {
 public:
  View(const Scene& scene, std::size_t except) : scene_(scene), except_(except) {}

  bool sees(Id id) const { return scene_.is_seen(entry(id), except_); }
  double distance_to(Id id, const Ray& ray, double range) const {
    const Entry& at = entry(id);
    if (!meets_bounds(ray, at.bounds, range)) return kMiss;
    return physics::distance_to(ray, at.solid, at.wheels, at.wheels_top);
  }
  Vector3 normal_of(Id id, const Ray& ray) const {
    const Entry& at = entry(id);
    return physics::normal_of(ray, at.solid, at.wheels, at.wheels_top);
  }
  Body body_of(Id id) const { return entry(id).body; }
  const base::Grid& grid() const { return scene_.grid_; }
  base::Grid::Block block_of(Id id) const { return entry(id).block; }
  Reach reach_of(Id id) const {
    const auto& [lower, upper] = entry(id).bounds;
    return {{lower.x, lower.y}, {upper.x, upper.y}};
  }

 private:
  const Entry& entry(Id id) const { return scene_.entries_[id]; }

  const Scene& scene_;
  std::size_t except_;
};

std::optional<RayHit> Scene::cast_ray(const Vector3& origin, const Vector3& direction,
                                      double max_range, std::size_t except) const {
  return physics::cast_ray(View(*this, except), origin, direction, max_range);
}

void Scene::cast_rays(const Frame& within, std::span<RayQuery> rays, std::span<Surface> surfaces,
                      std::size_t except) const {
  check_surfaces(rays, surfaces);
  const View view(*this, except);
  cast_fans(view, within, rays, surfaces, kLeastFan,
            [&](std::span<RayQuery> others, std::span<Surface> of_them) {
              cast_each(view, within, others, of_them);
            });
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
          return test.meets(box_around(wheel, entry.solid.box.axes[2]));
        };
        if (std::any_of(entry.wheels.begin(), entry.wheels.end(), is_met)) return true;
      }
    }
  }
  return false;
}

}  // namespace elsie::physics

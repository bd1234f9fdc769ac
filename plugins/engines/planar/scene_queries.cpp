// What rays and pyramids meet in the scene.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "planar_scene.h"
#include "ray_cast.h"
#include "ray_fan.h"
#include "surface_normals.h"

namespace elsie::physics {
namespace {

// Fewer rays from one point are cast as rays from different points are.
constexpr std::size_t kLeastFan = 64;
constexpr std::size_t kFewBodies = 32;

/// A part of a body in the world's frame.
class Placing {
 public:
  Placing(const Vector2& place, const Direction& ahead) : place_(place), ahead_(ahead) {}

  Vector3 direction(const Vector3& v) const {
    const Vector2 flat = ahead_.turn(Vector2{v.x, v.y});
    return {flat.x, flat.y, v.z};
  }
  Vector3 point(const Vector3& p) const {
    const Vector3 turned = direction(p);
    return {place_.x + turned.x, place_.y + turned.y, turned.z};
  }
  OrientedBox box(const OrientedBox& own) const {
    const auto& [a, b, c] = own.axes;
    return {point(own.center), {{direction(a), direction(b), direction(c)}}, own.half};
  }
  SensedSolid solid(const SensedSolid& own) const {
    SensedSolid there = own;
    there.put(box(own.box));
    return there;
  }

 private:
  Vector2 place_;
  Direction ahead_;
};

/// The interval of a ray in which it is within `half` of 0, in one direction.
inline void clip(double from, double along, double half, double& enter, double& leave) {
  if (along == 0.0) {
    if (std::abs(from) > half) leave = -1.0;
    return;
  }
  const double inverse = 1.0 / along;
  const double a = (-half - from) * inverse, b = (half - from) * inverse;
  enter = std::max(enter, std::min(a, b));
  leave = std::min(leave, std::max(a, b));
}

}  // namespace

/// The distance at which a ray meets a body, or kMiss if that is further than the range.
double PlanarScene::distance_to(Id id, const Ray& ray, double range) const {
  const SceneBody& entry = entries_[id];
  const Vector3 &origin = ray.origin, &direction = ray.direction;
  const Vector2 away{origin.x - entry.place.x, origin.y - entry.place.y};
  // Past its circle or behind it?
  const double across = away.x * direction.y - away.y * direction.x;
  const double flat = direction.x * direction.x + direction.y * direction.y;
  if (across * across > entry.reach * entry.reach * flat) return kMiss;
  const double to_middle = -(away.x * direction.x + away.y * direction.y);
  if (to_middle - entry.reach > range || to_middle + entry.reach < 0.0) return kMiss;
  return distance_past_circle(entry, id, origin, direction, range);
}

double PlanarScene::distance_past_circle(const SceneBody& entry, Id id, const Vector3& origin,
                                         const Vector3& direction, double range) const {
  const Vector2 away{origin.x - entry.place.x, origin.y - entry.place.y};
  if (direction.z <= 0.0 && origin.z < entry.bottom()) return kMiss;
  if (direction.z >= 0.0 && origin.z > entry.top()) return kMiss;

  const bool above_wheels = direction.z >= 0.0 && origin.z > entry.wheels_top;
  if (above_wheels && entry.section == SceneBody::Section::box) {
    const Vector2 from = entry.ahead.turn_back(away);
    const Vector2 along = entry.ahead.turn_back(Vector2{direction.x, direction.y});
    double enter = 0.0, leave = range;
    clip(from.x, along.x, entry.half.x, enter, leave);
    clip(from.y, along.y, entry.half.y, enter, leave);
    if (direction.z == 0.0) {
      return enter <= leave && origin.z >= entry.low && origin.z <= entry.high ? enter : kMiss;
    }
    const double middle = 0.5 * (entry.low + entry.high);
    clip(origin.z - middle, direction.z, 0.5 * (entry.high - entry.low), enter, leave);
    return enter <= leave ? enter : kMiss;
  }
  if (above_wheels && entry.section == SceneBody::Section::disc && direction.z == 0.0) {
    if (origin.z < entry.low || origin.z > entry.high) return kMiss;
    const double radius = entry.half.x;
    const double across = away.x * direction.y - away.y * direction.x;
    const double flat = direction.x * direction.x + direction.y * direction.y;
    const double to_middle = -(away.x * direction.x + away.y * direction.y);
    const double outside = away.x * away.x + away.y * away.y - radius * radius;
    if (outside <= 0.0) return 0.0;
    const double discriminant = radius * radius * flat - across * across;
    if (discriminant < 0.0 || to_middle < 0.0) return kMiss;
    return std::max(0.0, (to_middle - std::sqrt(discriminant)) / flat);
  }
  const Vector2 from = entry.ahead.turn_back(away);
  const Vector2 along = entry.ahead.turn_back(Vector2{direction.x, direction.y});
  const SensorShape& sensor_shape = *sensor_shapes_[id];
  return physics::distance_to({{from.x, from.y, origin.z}, {along.x, along.y, direction.z}},
                              sensor_shape.solid, sensor_shape.wheels, sensor_shape.wheels_top);
}

/// See ray_cast.h.
class PlanarScene::View {
 public:
  View(const PlanarScene& scene, std::size_t except) : scene_(scene), except_(except) {}

  bool sees(Id id) const { return is_seen(scene_.entries_[id], except_); }
  double distance_to(Id id, const Ray& ray, double range) const {
    return scene_.distance_to(id, ray, range);
  }
  Vector3 normal_of(Id id, const Ray& ray) const;
  Body body_of(Id id) const { return scene_.entries_[id].body(); }
  const base::Grid& grid() const { return scene_.grid_; }
  base::Grid::Block block_of(Id id) const { return scene_.blocks_[id]; }
  Reach reach_of(Id id) const { return scene_.reach_of(scene_.entries_[id]); }

 private:
  const PlanarScene& scene_;
  std::size_t except_;
};

Vector3 PlanarScene::View::normal_of(Id id, const Ray& ray) const {
  const SceneBody& entry = scene_.entries_[id];
  const Vector3 &origin = ray.origin, &direction = ray.direction;
  const Vector2 from =
      entry.ahead.turn_back(Vector2{origin.x - entry.place.x, origin.y - entry.place.y});
  const Vector2 along = entry.ahead.turn_back(Vector2{direction.x, direction.y});
  const SensorShape& shape = *scene_.sensor_shapes_[id];
  const Ray own({from.x, from.y, origin.z}, {along.x, along.y, direction.z});
  return Placing(entry.place, entry.ahead)
      .direction(physics::normal_of(own, shape.solid, shape.wheels, shape.wheels_top));
}

std::optional<RayHit> PlanarScene::cast_ray(const Vector3& origin, const Vector3& direction,
                                            double max_range, std::size_t except) const {
  return physics::cast_ray(View(*this, except), origin, direction, max_range);
}

void PlanarScene::cast_rays(const Frame& within, std::span<RayQuery> rays,
                            std::span<Surface> surfaces, std::size_t except) const {
  check_surfaces(rays, surfaces);
  const View view(*this, except);
  // Among few bodies, rays that run level are faster several at a time.
  const std::size_t least = entries_.size() < kFewBodies ? rays.size() + 1 : kLeastFan;
  cast_fans(view, within, rays, surfaces, least,
            [&](std::span<RayQuery> others, std::span<Surface> of_them) {
              if (!of_them.empty()) return cast_each(view, within, others, of_them);
              cast_level(view, within, others, except);
            });
}

/// Rays from different points: those that run level several at a time.
void PlanarScene::cast_level(const View& view, const Frame& within, std::span<RayQuery> rays,
                             std::size_t except) const {
  for (; !rays.empty(); rays = rays.subspan(std::min(LevelRays::kMost, rays.size()))) {
    const auto some = rays.first(std::min(LevelRays::kMost, rays.size()));
    LevelRays level;
    if (level.set(within, some) && cast_together(some, level, except)) continue;
    cast_each(view, within, some, {});
  }
}

/// Returns false if there are too many bodies around them.
bool PlanarScene::cast_together(std::span<RayQuery> rays, LevelRays& level,
                                std::size_t except) const {
  const Vector2& middle = level.middle();
  const NeighborList* const near = neighbors_of(except, middle, level.reach());
  if (!near) return false;
  std::array<const SceneBody*, LevelRays::kMostBoxes> boxes;
  std::size_t count = 0;
  const double reach = level.reach(), lowest = level.lowest();
  for (const Id id : near->near) {
    const SceneBody& entry = entries_[id];
    if (!entry.sensed || !entry.placed || !comes_within(entry, middle.x, middle.y, reach)) continue;
    const bool is_box = entry.section == SceneBody::Section::box && lowest > entry.wheels_top;
    if (is_box) {
      boxes[count] = &entry;
      ++count;
      if (count < boxes.size()) continue;
      level.meet_boxes(boxes);
      count = 0;
      continue;
    }
    for (std::uint32_t rest = level.meeting_circle(entry); rest != 0; rest &= rest - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(rest));
      if (k >= rays.size()) break;
      const double nearest = level.nearest(k);
      const double distance =
          distance_past_circle(entry, id, level.origin(k), level.direction(k), nearest);
      if (distance <= nearest) level.shorten(k, distance);
    }
  }
  if (count > 0) level.meet_boxes(std::span(boxes).first(count));
  level.answer(rays);
  return true;
}

bool PlanarScene::anything_in(const Pyramid& pyramid, std::size_t except) const {
  if (!(pyramid.range_m > 0.0)) return false;
  const PyramidTest test(pyramid);
  const auto& [lower, upper] = test.bounds();
  const base::Grid::Block block = grid_.block(lower.x, lower.y, upper.x, upper.y);
  for (int y = block.y0; y <= block.y1; ++y) {
    for (int x = block.x0; x <= block.x1; ++x) {
      for (const Id id : grid_.cell(x, y)) {
        const SceneBody& entry = entries_[id];
        const double reach = entry.reach;
        if (!is_seen(entry, except) || lower.z > entry.top() || upper.z < entry.bottom() ||
            lower.x > entry.place.x + reach || upper.x < entry.place.x - reach ||
            lower.y > entry.place.y + reach || upper.y < entry.place.y - reach) {
          continue;
        }
        const SensorShape& sensor_shape = *sensor_shapes_[id];
        const Placing placing(entry.place, entry.ahead);
        if (is_in(test, placing.solid(sensor_shape.solid))) return true;
        const auto is_met = [&](const Cylinder& wheel) {
          return test.meets(placing.box(box_around(wheel, {0.0, 0.0, 1.0})));
        };
        if (std::any_of(sensor_shape.wheels.begin(), sensor_shape.wheels.end(), is_met)) {
          return true;
        }
      }
    }
  }
  return false;
}

}  // namespace elsie::physics

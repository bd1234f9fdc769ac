#include "planar_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "elsie/world/parts.h"

#include "pyramid_test.h"

namespace elsie::physics {
namespace {

constexpr double kHair = 1e-9;  // m, so that rounding never hides a body

OrientedBox box_around(const Cylinder& wheel) {
  return {wheel.center,
          {{{wheel.axis.y, -wheel.axis.x, 0.0}, wheel.axis, {0.0, 0.0, 1.0}}},
          {wheel.radius, wheel.half_length, wheel.radius}};
}

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
  Cylinder cylinder(const Cylinder& own) const {
    return {point(own.center), direction(own.axis), own.radius, own.half_length};
  }

 private:
  Vector2 place_;
  Direction ahead_;
};

/// The interval of a ray in which it is within `half` of 0, in one direction.
void clip(double from, double along, double half, double& enter, double& leave) {
  if (along == 0.0) {
    if (std::abs(from) > half) leave = -1.0;
    return;
  }
  const double inverse = 1.0 / along;
  const double a = (-half - from) * inverse, b = (half - from) * inverse;
  enter = std::max(enter, std::min(a, b));
  leave = std::min(leave, std::max(a, b));
}

double distance_to_look(const Ray& ray, const Look& look) {
  double nearest = look.kind == Shape::Kind::box        ? distance_to_box(ray, look.box)
                   : look.kind == Shape::Kind::cylinder ? distance_to_cylinder(ray, look.round)
                                                        : distance_to_capsule(ray, look.round);
  // Most beams are level and above the wheels.
  if (ray.direction.z < 0.0 || ray.origin.z <= look.wheels_top) {
    for (const Cylinder& wheel : look.wheels) {
      nearest = std::min(nearest, distance_to_cylinder(ray, wheel));
    }
  }
  return nearest;
}

}  // namespace

Look Look::of_box(const Vector3& size, double bottom) {
  Look look;
  look.box = {{0.0, 0.0, bottom + 0.5 * size.z}, {}, 0.5 * size};
  look.box.axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  look.reach = std::hypot(look.box.half.x, look.box.half.y);
  return look;
}

Look Look::of(std::span<const Part> vehicle) {
  const Part& chassis = vehicle.front();
  const Shape& shape = chassis.shape;
  Look look = of_box(shape.size, chassis.frame.origin.z - 0.5 * shape.size.z);
  look.kind = shape.kind;
  const bool is_upright = shape.axis == Shape::Axis::up;
  if (shape.kind == Shape::Kind::box || (shape.kind == Shape::Kind::cylinder && is_upright)) {
    look.box.center.z += 0.5 * kSensorDeck;
    look.box.half.z += 0.5 * kSensorDeck;
  }
  const auto axis = static_cast<std::size_t>(shape.axis);
  const std::array halves{look.box.half.x, look.box.half.y, look.box.half.z};
  look.round = {look.box.center, look.box.axes[axis], shape.radius(), halves[axis]};
  look.reach = world::farthest_of(chassis, chassis.frame.origin);
  for (const Part& part : vehicle) {
    if (!std::holds_alternative<WheelJoint>(part.joint)) continue;
    const double radius = part.shape.radius();
    look.wheels.push_back(
        {part.frame.origin, part.frame.left, radius, 0.5 * part.shape.length()});
    look.wheels_top = std::max(look.wheels_top, part.frame.origin.z + radius);
    look.reach = std::max(look.reach, world::farthest_of(part, part.frame.origin));
  }
  return look;
}

PlanarScene::Id PlanarScene::add(Body body, bool sensed, Look look, const Vector2& place,
                                 const Direction& ahead) {
  Entry& entry = entries_.emplace_back();
  entry.body = body;
  entry.sensed = sensed;
  entry.reach = look.reach;
  entry.bottom = look.wheels.empty() ? look.box.center.z - look.box.half.z - kHair : -kHair;
  entry.top = std::max(look.box.center.z + look.box.half.z, look.wheels_top) + kHair;
  entry.is_box = look.wheels.empty() && look.kind == Shape::Kind::box;
  entry.half = {look.box.half.x, look.box.half.y};
  looks_.push_back(std::move(look));
  const auto id = static_cast<Id>(entries_.size() - 1);
  move(id, place, ahead);
  return id;
}

base::Grid::Block PlanarScene::block_of(const Entry& entry, double margin) const {
  double x = entry.reach, y = entry.reach;
  if (entry.is_box) {
    x = std::abs(entry.ahead.c) * entry.half.x + std::abs(entry.ahead.s) * entry.half.y;
    y = std::abs(entry.ahead.s) * entry.half.x + std::abs(entry.ahead.c) * entry.half.y;
  }
  x += margin + kHair;
  y += margin + kHair;
  return grid_.block(entry.place.x - x, entry.place.y - y, entry.place.x + x, entry.place.y + y);
}

void PlanarScene::move(Id id, const Vector2& place, const Direction& ahead) {
  Entry& entry = entries_[id];
  entry.place = place;
  entry.ahead = ahead;
  const base::Grid::Block block = block_of(entry, 0.0);
  if (entry.placed && block == entry.block) return;
  if (entry.placed) grid_.erase(id, entry.block);
  grid_.insert(id, block);
  entry.block = block;
  entry.placed = true;
}

void PlanarScene::remove(Id id) {
  Entry& entry = entries_[id];
  if (entry.placed) grid_.erase(id, entry.block);
  entry.placed = false;
}

void PlanarScene::try_entry(Id id, const Ray& ray, Best& best) const {
  const Entry& entry = entries_[id];
  const Vector2 away{ray.origin.x - entry.place.x, ray.origin.y - entry.place.y};
  const Vector2 from = entry.ahead.turn_back(away);
  const Vector2 along = entry.ahead.turn_back(Vector2{ray.direction.x, ray.direction.y});
  double distance = kMiss;
  if (entry.is_box) {
    double enter = 0.0, leave = best.hit.distance;
    const OrientedBox& box = looks_[id].box;
    clip(from.x, along.x, entry.half.x, enter, leave);
    clip(from.y, along.y, entry.half.y, enter, leave);
    clip(ray.origin.z - box.center.z, ray.direction.z, box.half.z, enter, leave);
    if (enter > leave) return;
    distance = enter;
  } else {
    distance = distance_to_look({{from.x, from.y, ray.origin.z}, {along.x, along.y, ray.direction.z}},
                                looks_[id]);
  }
  if (distance > best.hit.distance) return;
  if (distance < best.hit.distance || !best.found || best.hit.floor ||
      entry.body < best.hit.body) {
    best = {{distance, entry.body, false}, true};
  }
}

std::optional<RayHit> PlanarScene::cast_ray(const Vector3& origin, const Vector3& direction,
                                            double max_range, std::size_t except) const {
  if (!std::isfinite(dot(origin, origin) + dot(direction, direction))) return std::nullopt;
  const Ray ray(origin, direction);
  Best best;
  best.hit.distance = max_range;
  if (direction.z < 0.0) {
    // The floor is seen from above; a ray from below hits it at once.
    const double distance = std::max(0.0, -origin.z / direction.z);
    if (distance <= max_range) best = {{distance, {}, true}, true};
  }
  const double flat = direction.x * direction.x + direction.y * direction.y;

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
      if (!is_seen(entry, except)) continue;
      // Past its circle, or beyond the nearest hit?
      const double ox = entry.place.x - origin.x, oy = entry.place.y - origin.y;
      const double across = ox * direction.y - oy * direction.x;
      const double reach = entry.reach + kHair;
      if (across * across > reach * reach * flat) continue;
      const double nearest = ox * direction.x + oy * direction.y - reach;
      if (nearest > best.hit.distance || nearest + 2.0 * reach < 0.0) continue;
      if (direction.z <= 0.0 ? origin.z < entry.bottom : origin.z > entry.top) continue;
      if (direction.z == 0.0 && origin.z > entry.top) continue;
      try_entry(id, ray, best);
    }
    if (best.hit.distance <= std::min(at_column_end, at_row_end)) break;
    if (at_column_end < at_row_end) {
      x += step_x;
      at_column_end = leave_column();
    } else {
      y += step_y;
      at_row_end = leave_row();
    }
  }
  return best.found ? std::optional(best.hit) : std::nullopt;
}

bool PlanarScene::anything_in(const Pyramid& pyramid, std::size_t except) const {
  if (!(pyramid.range_m > 0.0)) return false;
  const PyramidTest test(pyramid);
  const auto& [lower, upper] = test.bounds();
  const base::Grid::Block block = grid_.block(lower.x, lower.y, upper.x, upper.y);
  for (int y = block.y0; y <= block.y1; ++y) {
    for (int x = block.x0; x <= block.x1; ++x) {
      for (const Id id : grid_.cell(x, y)) {
        const Entry& entry = entries_[id];
        const double reach = entry.reach + kHair;
        if (!is_seen(entry, except) || lower.z > entry.top || upper.z < entry.bottom ||
            lower.x > entry.place.x + reach || upper.x < entry.place.x - reach ||
            lower.y > entry.place.y + reach || upper.y < entry.place.y - reach) {
          continue;
        }
        const Look& look = looks_[id];
        const Placing placing(entry.place, entry.ahead);
        if (look.kind == Shape::Kind::cylinder ? test.meets(placing.cylinder(look.round))
                                               : test.meets(placing.box(look.box))) {
          return true;
        }
        const auto is_met = [&](const Cylinder& wheel) {
          return test.meets(placing.box(box_around(wheel)));
        };
        if (std::any_of(look.wheels.begin(), look.wheels.end(), is_met)) return true;
      }
    }
  }
  return false;
}

}  // namespace elsie::physics

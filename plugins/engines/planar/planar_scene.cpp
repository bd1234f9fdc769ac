#include "planar_scene.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <tuple>
#include <utility>

#include "elsie/world/parts.h"

#include "outline.h"

namespace elsie::physics {
namespace {

// The bodies around a robot are listed again when something has moved this far. A larger margin
// makes longer lists.
constexpr double kMargin = 0.2;  // m

// Around a robot with longer rays, each ray is followed through the grid.
constexpr double kFarthest = 6.0;  // m

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

/// The floor is seen from above; a ray from below hits it at once.
double distance_to_floor(const Vector3& origin, const Vector3& direction) {
  return direction.z < 0.0 ? std::max(0.0, -origin.z / direction.z) : kMiss;
}

Look look_of(const Shape& shape, const OrientedBox& box, double reach) {
  Look look;
  look.solid = SensedSolid(shape);
  look.solid.put(box);
  look.reach = reach;
  return look;
}

/// An upright box of this size around a place above the origin.
OrientedBox upright_box(const Vector3& size, double bottom) {
  return {{0.0, 0.0, bottom + 0.5 * size.z}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 0.5 * size};
}

}  // namespace

Look Look::of(const Shape& shape, double bottom) {
  return look_of(shape, upright_box(shape.size, bottom), Outline::of(shape, 0.0).reach);
}

Look Look::of(std::span<const Part> vehicle) {
  const Part& chassis = vehicle.front();
  const Shape& shape = chassis.shape;
  const double bottom = chassis.frame.origin.z - 0.5 * shape.size.z;
  Look look = look_of(shape, with_deck(shape, upright_box(shape.size, bottom)),
                      world::farthest_of(chassis, chassis.frame.origin));
  for (const Part& part : vehicle) {
    if (!std::holds_alternative<WheelJoint>(part.joint)) continue;
    const double radius = part.shape.radius();
    look.wheels.push_back({part.frame.origin, part.frame.left, radius, 0.5 * part.shape.length()});
    look.wheels_top = std::max(look.wheels_top, part.frame.origin.z + radius);
    look.reach = std::max(look.reach, world::farthest_of(part, part.frame.origin));
  }
  return look;
}

PlanarScene::Id PlanarScene::add(Body body, bool sensed, bool moves,
                                 std::shared_ptr<const Look> shared, const Vector2& place,
                                 const Direction& ahead) {
  const Look& look = *shared;
  SceneBody& entry = entries_.emplace_back();
  const OrientedBox& box = look.solid.box;
  entry.kind = body.kind;
  entry.index = static_cast<std::uint32_t>(body.index);
  entry.sensed = sensed;
  entry.moves = moves;
  entry.reach = look.reach + kHair;
  entry.half = {box.half.x, box.half.y};
  entry.low = box.center.z - box.half.z;
  entry.high = box.center.z + box.half.z;
  if (!look.wheels.empty()) entry.wheels_top = look.wheels_top;
  const Shape::Kind kind = look.solid.kind;
  const bool is_disc = kind == Shape::Kind::cylinder && look.solid.axis == Shape::Axis::up;
  entry.outside = kind == Shape::Kind::box ? SceneBody::Outside::box
                  : is_disc                ? SceneBody::Outside::disc
                                           : SceneBody::Outside::other;
  entry.place = place;
  entry.ahead = ahead;
  blocks_.emplace_back();
  looks_.push_back(std::move(shared));
  const auto id = static_cast<Id>(entries_.size() - 1);
  this->place(id);
  if (body.kind == BodyKind::robot) {
    if (body.index < around_.size()) {
      around_[body.index].pulls = true;
    } else {
      around_.resize(body.index + 1);
    }
  }
  return id;
}

base::Grid::Block PlanarScene::block_of(const SceneBody& entry) const {
  double x = entry.reach, y = x;
  if (!entry.moves && entry.outside == SceneBody::Outside::box) {
    const Vector2& half = entry.half;
    const double c = std::abs(entry.ahead.c), s = std::abs(entry.ahead.s);
    x = c * half.x + s * half.y + kHair;
    y = s * half.x + c * half.y + kHair;
  }
  return grid_.block(entry.place.x - x, entry.place.y - y, entry.place.x + x, entry.place.y + y);
}

/// Enters a body in the grid.
void PlanarScene::place(Id id) {
  SceneBody& entry = entries_[id];
  const base::Grid::Block block = block_of(entry);
  if (!entry.placed || block != blocks_[id]) {
    if (entry.placed) grid_.erase(id, blocks_[id]);
    grid_.insert(id, block);
    blocks_[id] = block;
    entry.placed = true;
  }
  // Cells at the border reach to infinity.
  const auto least = [&](int first, int last, int count, auto border) {
    const double a = first == 0 ? -kMiss : border(first) + entry.reach;
    const double b = last == 0 ? -kMiss : border(last) - entry.reach;
    const double c = first == count - 1 ? kMiss : border(first + 1) + entry.reach;
    const double d = last == count - 1 ? kMiss : border(last + 1) - entry.reach;
    return std::pair(std::max(a, b), std::min(c, d));
  };
  const auto column = [this](int i) { return grid_.column_border(i); };
  const auto row = [this](int i) { return grid_.row_border(i); };
  std::tie(entry.least.x, entry.most.x) = least(block.x0, block.x1, grid_.columns(), column);
  std::tie(entry.least.y, entry.most.y) = least(block.y0, block.y1, grid_.rows(), row);
}

void PlanarScene::move(Id id, const Vector2& place, const Direction& ahead, Moves& moves) {
  SceneBody& entry = entries_[id];
  const double dx = place.x - entry.place.x, dy = place.y - entry.place.y;
  moves.farthest = std::max(moves.farthest, dx * dx + dy * dy);
  entry.place = place;
  entry.ahead = ahead;
  const bool stays = place.x >= entry.least.x && place.x < entry.most.x &&
                     place.y >= entry.least.y && place.y < entry.most.y;
  if (!stays) moves.leavers.push_back(id);
}

void PlanarScene::settle(std::span<Moves> moves) {
  double farthest = 0.0;
  for (Moves& each : moves) {
    farthest = std::max(farthest, each.farthest);
    for (const Id id : each.leavers) place(id);
    each.farthest = 0.0;
    each.leavers.clear();
  }
  odometer_ += std::sqrt(farthest);
}

void PlanarScene::remove(Id id) {
  SceneBody& entry = entries_[id];
  if (entry.placed) grid_.erase(id, blocks_[id]);
  entry.placed = false;
}

void PlanarScene::fit() {
  entries_.shrink_to_fit();
  blocks_.shrink_to_fit();
  looks_.shrink_to_fit();
  around_.shrink_to_fit();
}

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
  if (above_wheels && entry.outside == SceneBody::Outside::box) {
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
  if (above_wheels && entry.outside == SceneBody::Outside::disc && direction.z == 0.0) {
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
  const Look& look = *looks_[id];
  return physics::distance_to({{from.x, from.y, origin.z}, {along.x, along.y, direction.z}},
                              look.solid, look.wheels, look.wheels_top);
}

/// From cell to cell along the ray (Amanatides and Woo 1987).
void PlanarScene::walk(const Ray& ray, std::size_t except, Best& best) const {
  const Vector3 &origin = ray.origin, &direction = ray.direction;
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
      const SceneBody& entry = entries_[id];
      if (!is_seen(entry, except)) continue;
      const double distance = distance_to(id, ray, best.hit.distance);
      if (distance == kMiss || distance > best.hit.distance) continue;
      if (distance < best.hit.distance || !best.found || best.hit.floor ||
          entry.body() < best.hit.body) {
        best = {{distance, entry.body(), false}, true};
      }
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
}

std::optional<RayHit> PlanarScene::cast_ray(const Vector3& origin, const Vector3& direction,
                                            double max_range, std::size_t except) const {
  if (!std::isfinite(dot(origin, origin) + dot(direction, direction))) return std::nullopt;
  Best best;
  best.hit.distance = max_range;
  if (const double floor = distance_to_floor(origin, direction); floor <= max_range) {
    best = {{floor, {}, true}, true};
  }
  walk(Ray(origin, direction), except, best);
  return best.found ? std::optional(best.hit) : std::nullopt;
}

/// The bodies around a robot: at least all within the radius. Null if the grid should be asked
/// instead.
const PlanarScene::Around* PlanarScene::around(std::size_t robot, const Vector2& middle,
                                               double radius) const {
  if (robot >= around_.size()) return nullptr;
  Around& known = around_[robot];
  const double dx = middle.x - known.middle.x, dy = middle.y - known.middle.y;
  const double left = known.until - odometer_ - radius;
  if (left >= 0.0 && dx * dx + dy * dy <= left * left && known.bodies == entries_.size()) {
    return &known;
  }
  if (!(radius <= kFarthest)) return nullptr;
  known.near.clear();
  known.middle = middle;
  known.wanted = std::max(known.wanted, radius);
  const double far = known.wanted + kMargin;
  known.until = far + odometer_;
  known.bodies = static_cast<std::uint32_t>(entries_.size());
  const base::Grid::Block block =
      grid_.block(middle.x - far, middle.y - far, middle.x + far, middle.y + far);
  for (int y = block.y0; y <= block.y1; ++y) {
    for (int x = block.x0; x <= block.x1; ++x) {
      for (const Id id : grid_.cell(x, y)) {
        const SceneBody& entry = entries_[id];
        // Once: in the first of its cells.
        if (x == std::max(blocks_[id].x0, block.x0) && y == std::max(blocks_[id].y0, block.y0) &&
            !is_of(entry, robot) && comes_within(entry, middle.x, middle.y, far)) {
          known.near.push_back(id);
        }
      }
    }
  }
  return &known;
}

void PlanarScene::cast_rays(const Frame& within, std::span<RayQuery> rays,
                            std::size_t except) const {
  for (; !rays.empty(); rays = rays.subspan(std::min(LevelRays::kMost, rays.size()))) {
    const auto some = rays.first(std::min(LevelRays::kMost, rays.size()));
    LevelRays level;
    if (level.set(within, some) && cast_together(some, level, except)) continue;
    for (RayQuery& ray : some) {
      const auto hit = cast_ray(within.point(ray.from->origin), within.direction(ray.from->forward),
                                ray.max_range_m, except);
      ray.distance_m = hit ? hit->distance : RayQuery::kNothing;
    }
  }
}

/// Returns false if there are too many bodies around them.
bool PlanarScene::cast_together(std::span<RayQuery> rays, LevelRays& level,
                                std::size_t except) const {
  const Vector2& middle = level.middle();
  const Around* const near = around(except, middle, level.reach());
  if (!near) return false;
  std::array<const SceneBody*, LevelRays::kMostBoxes> boxes;
  std::size_t count = 0;
  const double reach = level.reach(), lowest = level.lowest();
  for (const Id id : near->near) {
    const SceneBody& entry = entries_[id];
    if (!entry.sensed || !entry.placed || !comes_within(entry, middle.x, middle.y, reach)) continue;
    const bool is_box = entry.outside == SceneBody::Outside::box && lowest > entry.wheels_top;
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
        const Look& look = *looks_[id];
        const Placing placing(entry.place, entry.ahead);
        if (is_in(test, placing.solid(look.solid))) return true;
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

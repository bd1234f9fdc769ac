#include "planar_scene.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace elsie::physics {
namespace {

// The bodies around a robot are listed again when something has moved this far. A larger margin
// makes longer lists.
constexpr double kMargin = 0.2;  // m

// Around a robot with longer rays, each ray is followed through the grid.
constexpr double kFarthest = 6.0;  // m

}  // namespace

PlanarScene::Id PlanarScene::add(Body body, bool sensed, bool moves,
                                 std::shared_ptr<const SensorShape> shared, const Vector2& place,
                                 const Direction& ahead) {
  const SensorShape& sensor_shape = *shared;
  SceneBody& entry = entries_.emplace_back();
  const OrientedBox& box = sensor_shape.solid.box;
  entry.kind = body.kind;
  entry.index = static_cast<std::uint32_t>(body.index);
  entry.sensed = sensed;
  entry.moves = moves;
  entry.reach = sensor_shape.reach + kHair;
  entry.half = {box.half.x, box.half.y};
  entry.low = box.center.z - box.half.z;
  entry.high = box.center.z + box.half.z;
  if (!sensor_shape.wheels.empty()) entry.wheels_top = sensor_shape.wheels_top;
  const Shape::Kind kind = sensor_shape.solid.kind;
  const bool is_disc = kind == Shape::Kind::cylinder && sensor_shape.solid.axis == Shape::Axis::up;
  entry.section = kind == Shape::Kind::box ? SceneBody::Section::box
                  : is_disc                ? SceneBody::Section::disc
                                           : SceneBody::Section::other;
  entry.place = place;
  entry.ahead = ahead;
  blocks_.emplace_back();
  sensor_shapes_.push_back(std::move(shared));
  const auto id = static_cast<Id>(entries_.size() - 1);
  this->place(id);
  if (body.kind == BodyKind::robot) {
    if (body.index < neighbors_.size()) {
      neighbors_[body.index].pulls = true;
    } else {
      neighbors_.resize(body.index + 1);
    }
  }
  return id;
}

Reach PlanarScene::reach_of(const SceneBody& entry) const {
  double x = entry.reach, y = x;
  if (!entry.moves && entry.section == SceneBody::Section::box) {
    const Vector2& half = entry.half;
    const double c = std::abs(entry.ahead.c), s = std::abs(entry.ahead.s);
    x = c * half.x + s * half.y + kHair;
    y = s * half.x + c * half.y + kHair;
  }
  const Vector2& at = entry.place;
  return {{at.x - x, at.y - y}, {at.x + x, at.y + y}};
}

/// Enters a body in the grid.
void PlanarScene::place(Id id) {
  SceneBody& entry = entries_[id];
  const auto [from, to] = reach_of(entry);
  const base::Grid::Block block = grid_.block(from.x, from.y, to.x, to.y);
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

void PlanarScene::put(Id id, const Vector2& place, const Direction& ahead) {
  entries_[id].place = place;
  entries_[id].ahead = ahead;
  this->place(id);
  // It may be nearer to anything than the odometer tells.
  clear_until_.clear();
  for (NeighborList& known : neighbors_) known.bodies = 0;
}

/// The bodies around a robot: at least all within the radius. Null if the grid should be asked
/// instead.
const PlanarScene::NeighborList* PlanarScene::neighbors_of(std::size_t robot, const Vector2& middle,
                                                           double radius) const {
  if (robot >= neighbors_.size()) return nullptr;
  NeighborList& known = neighbors_[robot];
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

}  // namespace elsie::physics

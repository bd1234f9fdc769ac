// The places of all bodies in a grid: what sensors see, and which bodies are near each other.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "elsie/api/body.h"
#include "elsie/api/sensor.h"
#include "elsie/base/grid.h"
#include "elsie/physics/engine.h"
#include "elsie/world/parts.h"

#include "level_rays.h"
#include "plane.h"
#include "ray_cast.h"
#include "scene_body.h"
#include "sensor_shape.h"

namespace elsie::physics {

class PlanarScene {
 public:
  using Id = base::Grid::Id;

  explicit PlanarScene(const world::Arena& arena) : grid_(arena.length, arena.width) {}

  /// Adds a body; its ids count upwards from 0. Only `sensed` bodies take part in rays and
  /// pyramids.
  /// `moves`: move() will be called.
  Id add(Body body, bool sensed, bool moves, std::shared_ptr<const SensorShape> sensor_shape,
         const Vector2& place, const Direction& ahead);
  /// What one thread notes in a round of moves.
  struct Moves {
    double farthest = 0.0;    // m2
    std::vector<Id> leavers;  // of their cells in the grid
  };
  /// Moves a body, at most once in a round. Several threads may move different bodies at once.
  void move(Id id, const Vector2& place, const Direction& ahead, Moves& moves);
  /// Ends a round.
  void settle(std::span<Moves> moves);
  void remove(Id id);
  /// Puts any body anywhere, also one that was removed; not in a round.
  void put(Id id, const Vector2& place, const Direction& ahead);

  // Since the last round:
  const Vector2& place_of(Id id) const { return entries_[id].place; }
  const Direction& ahead_of(Id id) const { return entries_[id].ahead; }

  /// Calls `call` with every other body that may be no further than `margin` away from the circle
  /// around this one; perhaps more than once.
  template <class Call>
  void for_each_near(Id id, double margin, Call call) const;
  /// True if for_each_near() would find nothing, as far as an earlier search can tell.
  bool is_clear(Id id, double margin) const { return odometer_ + 0.5 * margin < clear_until_[id]; }
  /// Must be called before is_clear() and for_each_near() when bodies have been added.
  void begin_search() {
    if (clear_until_.size() != entries_.size()) clear_until_.assign(entries_.size(), 0.0);
  }

  std::optional<RayHit> cast_ray(const Vector3& origin, const Vector3& direction, double max_range,
                                 std::size_t except) const;
  /// As Engine::cast_rays().
  void cast_rays(const Frame& within, std::span<RayQuery> rays, std::span<Surface> surfaces,
                 std::size_t except) const;
  bool anything_in(const Pyramid& pyramid, std::size_t except) const;

 private:
  /// What is around a robot, so that most queries need not search the grid (Verlet, "Computer
  /// experiments on classical fluids", 1967). A list of all bodies within R of the middle m, made
  /// when the odometer read o, still has all within r of the place p at the reading o' if
  ///
  ///   r + |p - m| + (o' - o) <= R,
  ///
  /// because the odometer adds up the farthest move of any body in each round: no body has come
  /// nearer by more than o' - o.
  struct NeighborList {
    std::vector<Id> near;  // all that came within the radius, but not the robot itself
    Vector2 middle;
    double until = -1.0;       // m, R + o
    double wanted = 0.0;       // m, the largest radius that was asked for
    std::uint32_t bodies = 0;  // the number of bodies when it was made
    bool pulls = false;        // the robot has segments, which may meet each other
  };

  class View;
  Reach reach_of(const SceneBody& entry) const;
  void place(Id id);
  static bool is_of(const SceneBody& entry, std::size_t robot) {
    return entry.kind == BodyKind::robot && entry.index == robot;
  }
  static bool is_seen(const SceneBody& entry, std::size_t except) {
    return entry.sensed && !is_of(entry, except);
  }
  /// Whether the body comes within this distance of a point; perhaps also if it nearly does.
  static bool comes_within(const SceneBody& entry, double x, double y, double distance) {
    const double dx = x - entry.place.x, dy = y - entry.place.y;
    const double far = entry.reach + distance;
    if (dx * dx + dy * dy > far * far) return false;
    if (entry.moves || entry.section != SceneBody::Section::box) return true;
    const Vector2 at = entry.ahead.turn_back(Vector2{dx, dy});
    return std::abs(at.x) <= entry.half.x + distance + kHair &&
           std::abs(at.y) <= entry.half.y + distance + kHair;
  }
  /// The distance of the body from a point, or less.
  static double distance_to(const SceneBody& entry, double x, double y) {
    const double dx = x - entry.place.x, dy = y - entry.place.y;
    if (entry.moves || entry.section != SceneBody::Section::box) {
      return std::sqrt(dx * dx + dy * dy) - entry.reach;
    }
    const Vector2 at = entry.ahead.turn_back(Vector2{dx, dy});
    return std::max(std::abs(at.x) - entry.half.x, std::abs(at.y) - entry.half.y);
  }
  double distance_to(Id id, const Ray& ray, double range) const;
  double distance_past_circle(const SceneBody& entry, Id id, const Vector3& origin,
                              const Vector3& direction, double range) const;
  const NeighborList* neighbors_of(std::size_t robot, const Vector2& middle, double radius) const;
  void cast_level(const View& view, const Frame& within, std::span<RayQuery> rays,
                  std::size_t except) const;
  bool cast_together(std::span<RayQuery> rays, LevelRays& level, std::size_t except) const;

  base::Grid grid_;
  std::vector<SceneBody> entries_;
  std::vector<base::Grid::Block> blocks_;  // of the entries
  std::vector<std::shared_ptr<const SensorShape>> sensor_shapes_;
  /// The reading of the odometer up to which nothing can touch a body's circle: the gap g to the
  /// nearest body closes by at most twice the odometer's way, so that o + g / 2 is such a reading.
  mutable std::vector<double> clear_until_;
  mutable std::vector<NeighborList>
      neighbors_;          // of robots; each belongs to the thread that asks for it
  double odometer_ = 0.0;  // m: the sum of the farthest moves of all rounds
};

template <class Call>
void PlanarScene::for_each_near(Id id, double margin, Call call) const {
  const SceneBody& self = entries_[id];
  const double x0 = self.place.x, y0 = self.place.y, reach = self.reach + margin;
  const bool is_alone = self.kind == BodyKind::robot && !neighbors_[self.index].pulls;
  if (const NeighborList* near = is_alone ? neighbors_of(self.index, self.place, reach) : nullptr) {
    // Nothing nearer than this is missing in the list.
    double distance =
        near->until - odometer_ - std::hypot(x0 - near->middle.x, y0 - near->middle.y);
    for (const Id other : near->near) {
      const SceneBody& entry = entries_[other];
      if (!entry.placed) continue;
      if (comes_within(entry, x0, y0, reach)) {
        distance = 0.0;
        call(other);
      } else if (distance > reach) {
        distance = std::min(distance, distance_to(entry, x0, y0));
      }
    }
    // Both may move.
    clear_until_[id] = odometer_ + 0.5 * (distance - self.reach) - kHair;
    return;
  }
  const base::Grid::Block block = grid_.block(x0 - reach, y0 - reach, x0 + reach, y0 + reach);
  for (int y = block.y0; y <= block.y1; ++y) {
    for (int x = block.x0; x <= block.x1; ++x) {
      for (const Id other : grid_.cell(x, y)) {
        if (other != id && comes_within(entries_[other], x0, y0, reach)) call(other);
      }
    }
  }
}

}  // namespace elsie::physics

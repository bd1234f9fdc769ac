// The places of all bodies in a grid: what sensors see, and which bodies are near each other.
#pragma once

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

#include "plane.h"
#include "ray_tests.h"
#include "shapes.h"

namespace elsie::physics {

/// A body as range sensors see it, in its own upright frame.
struct Look {
  Shape::Kind kind = Shape::Kind::box;
  OrientedBox box;  // around it, with the sensor deck of a flat top
  Cylinder round;   // unused for a box; for a ball or a capsule, the cylinder around it
  std::vector<Cylinder> wheels;
  double wheels_top = 0.0;       // m
  double reach = 0.0;            // m, from above: the radius of the circle around it
  std::vector<Vector2> corners;  // of a prism, from above: counter-clockwise; `box` is around it

  /// `vehicle`: a chassis and what is below it.
  static Look of(std::span<const Part> vehicle);
  /// An obstacle, charger or wall.
  static Look of(const world::Fixture& fixture, double bottom);
};

class PlanarScene {
 public:
  using Id = base::Grid::Id;

  explicit PlanarScene(const world::Arena& arena) : grid_(arena.length, arena.width) {}

  /// Adds a body; its ids count upwards from 0. Only `sensed` bodies take part in rays and
  /// pyramids.
  Id add(Body body, bool sensed, std::shared_ptr<const Look> look, const Vector2& place,
         const Direction& ahead);
  void move(Id id, const Vector2& place, const Direction& ahead);
  void remove(Id id);

  /// Calls `call` with every other body that may be no further than `margin` away from the circle
  /// around this one; perhaps more than once.
  template <class Call>
  void for_each_near(Id id, double margin, Call call) const;

  std::optional<RayHit> cast_ray(const Vector3& origin, const Vector3& direction, double max_range,
                                 std::size_t except) const;
  /// As Engine::cast_rays().
  void cast_rays(std::span<RayQuery> rays, std::size_t except) const;
  bool anything_in(const Pyramid& pyramid, std::size_t except) const;

 private:
  /// How much of a look the frequent rays need.
  enum class Outside : std::uint8_t { box, disc, other };
  struct Entry {
    Vector2 place;
    Direction ahead;
    double reach = 0.0;
    Vector2 half;                    // of a box
    double bottom = 0.0, top = 0.0;  // of all of it
    double low = 0.0, high = 0.0;    // of the box or disc
    double wheels_top = -1.0;        // m; negative: no wheels
    Body body;
    Outside outside = Outside::box;
    bool sensed = false;
    bool placed = false;
    base::Grid::Block block;
  };
  struct Best {
    RayHit hit;
    bool found = false;
  };
  static constexpr std::size_t kMostCandidates = 64;
  struct Candidate {
    Id id;
    double x, y;  // from the middle of the rays
    double reach;
  };
  struct Candidates {
    Vector2 middle;  // of the origins of the rays
    std::size_t count = 0;
    std::array<Candidate, kMostCandidates> all;
  };

  base::Grid::Block block_of(const Entry& entry, double margin) const;
  bool is_seen(const Entry& entry, std::size_t except) const {
    return entry.sensed && !(entry.body.kind == BodyKind::robot && entry.body.index == except);
  }
  /// Whether the body comes within this distance of a point; perhaps also if it nearly does.
  static bool comes_within(const Entry& entry, double x, double y, double distance) {
    const double dx = x - entry.place.x, dy = y - entry.place.y;
    const double far = entry.reach + distance;
    if (dx * dx + dy * dy > far * far) return false;
    if (entry.outside != Outside::box || entry.wheels_top >= 0.0) return true;
    const Vector2 at = entry.ahead.turn_back(Vector2{dx, dy});
    return std::abs(at.x) <= entry.half.x + distance && std::abs(at.y) <= entry.half.y + distance;
  }
  double distance_to(Id id, const Ray& ray, double range) const;
  double distance_past_circle(const Entry& entry, Id id, const Ray& ray, double range) const;
  bool gather(std::span<const RayQuery> rays, std::size_t except, Candidates& found) const;
  void walk(const Ray& ray, std::size_t except, Best& best) const;

  base::Grid grid_;
  std::vector<Entry> entries_;
  std::vector<std::shared_ptr<const Look>> looks_;
};

template <class Call>
void PlanarScene::for_each_near(Id id, double margin, Call call) const {
  const Entry& self = entries_[id];
  const double x0 = self.place.x, y0 = self.place.y, reach = self.reach + margin;
  const base::Grid::Block block = block_of(self, margin);
  for (int y = block.y0; y <= block.y1; ++y) {
    for (int x = block.x0; x <= block.x1; ++x) {
      for (const Id other : grid_.cell(x, y)) {
        if (other != id && comes_within(entries_[other], x0, y0, reach)) call(other);
      }
    }
  }
}

}  // namespace elsie::physics

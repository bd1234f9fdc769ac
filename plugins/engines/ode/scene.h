// The places of all bodies: finds bodies near each other, and answers the queries of sensors. It
// contains no dynamics.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "elsie/api/sensor.h"
#include "elsie/base/grid.h"
#include "elsie/physics/engine.h"

#include "sensed_solid.h"

namespace elsie::physics {

class Scene {
 public:
  using Id = base::Grid::Id;

  explicit Scene(const world::Arena& arena);

  /// Adds a part of a body, still without a place: part 0 is the robot, 1 and above its segments.
  /// Only `sensed` parts take part in rays and pyramids.
  Id add(Body body, bool sensed, std::size_t part = 0);
  /// Gives a box that was added its shape.
  void shape_box(Id id, const Shape& shape) { entries_[id].solid = SensedSolid(shape); }
  /// Puts a box somewhere. `reach` is how far it may come in the next step, m.
  void place_box(Id id, const OrientedBox& box, double reach);
  /// Puts a robot or a segment somewhere: what sensors see of it (chassis with sensor deck, and
  /// wheels), and bounds that enclose all of it. Returns true if it comes into other cells; it must
  /// then be entered before any query. Several threads may do so for different robots at once.
  bool place_robot(Id id, const SensedSolid& sensed, const std::vector<Cylinder>& wheels,
                   const Aabb& enclosing, double reach);
  /// Enters a robot or a segment into the cells of its place.
  void enter(Id id);
  void remove(Id id);

  const Body& body(Id id) const { return entries_[id].body; }
  std::size_t part(Id id) const { return entries_[id].part; }
  double reach(Id id) const { return entries_[id].reach; }

  /// All other parts whose bounds come within both reaches; ascending, each once.
  void neighbors(Id id, std::vector<Id>& found) const;

  std::optional<RayHit> cast_ray(const Vector3& origin, const Vector3& direction, double max_range,
                                 std::size_t except) const;
  /// As Engine::cast_rays().
  void cast_rays(const Frame& within, std::span<RayQuery> rays, std::span<Surface> surfaces,
                 std::size_t except) const;
  bool anything_in(const Pyramid& pyramid, std::size_t except) const;

 private:
  class View;
  struct Entry {
    Aabb bounds;  // of the body; slightly larger, so that rounding never hides it
    double reach = 0.0;
    Body body;
    std::size_t part = 0;
    bool sensed = false;
    bool placed = false;
    bool is_robot = false;
    SensedSolid solid;             // as sensors see it
    std::vector<Cylinder> wheels;  // of a robot
    double wheels_top = 0.0;
    base::Grid::Block block;  // in which it is entered
    base::Grid::Block next;   // of its place
  };

  bool place(Id id, const Aabb& bounds, double reach);
  bool is_seen(const Entry& entry, std::size_t except) const {
    return entry.sensed && !(entry.is_robot && entry.body.index == except);
  }

  base::Grid grid_;
  std::vector<Entry> entries_;
};

}  // namespace elsie::physics

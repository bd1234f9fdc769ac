// What sensors find in a world, by places and by the bodies that rays hit.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "elsie/api/surroundings.h"
#include "elsie/world/description.h"
#include "elsie/world/floor.h"

namespace elsie::world {

/// A view of a world. Make another one when the world changes.
class Things {
 public:
  explicit Things(const World& world);

  /// Bodies have the order of the world: of obstacles, first the world's, then the boxes of
  /// chargers that are seen by range sensors.
  Thing of(const Surface& surface) const;
  std::span<const LampView> lamps() const { return lamps_; }
  Colour floor_colour(const Vector2& place) const { return floor_.colour_at(place); }
  /// Surroundings::things_within(), except for robots. `place_of`: where an obstacle is, by its
  /// index; none: it is gone.
  void within(const Pose& from, double radius_m,
              const std::function<std::optional<Vector2>(std::size_t)>& place_of,
              std::vector<NearThing>& things) const;
  /// Appends a robot that is at `place`, if it is within the radius.
  void add_robot(std::size_t robot, const Pose& from, const Pose& place, double radius_m,
                 std::vector<NearThing>& things) const;

 private:
  Thing robot(std::size_t index) const;
  Thing obstacle(const Obstacle& obstacle) const;
  Thing charger(const Charger& charger) const;

  const World& world_;
  std::vector<std::size_t> near_;      // obstacles that within() gives
  std::vector<const Charger*> boxes_;  // chargers that are bodies
  std::vector<LampView> lamps_;
  FloorMap floor_;
};

}  // namespace elsie::world

// Areas of bodies on the floor: whether they overlap, and whether they are in the arena.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/world/description.h"
#include "elsie/world/parts.h"

namespace elsie::world {

/// A rotated rectangle, a disc or a convex outline on the floor with a bottom and a top.
struct Footprint {
  double x = 0.0, y = 0.0;  // m, its middle
  double heading_rad = 0.0;
  double half_length = 0.0, half_width = 0.0;  // m, along the heading and across
  double bottom = 0.0, top = 0.0;              // m
  bool round = false;                          // true: a disc; its radius is half its length
  std::vector<Vector2> outline{};              // of a prism; else empty
  double margin = 0.0;                         // m, around the outline

  /// Its extent from its middle in the direction of a unit vector, m.
  double reach(double ux, double uy) const;
  /// All sides moved outwards, m, or inwards if negative.
  Footprint grown(double by) const;
};

/// The extents of a vehicle from its origin, m: ahead and behind, to either side, and upwards. A
/// part that extends beyond the chassis by less than a nanometre does not count.
Vector3 extents_of(std::span<const Part> vehicle);
/// The radius of the disc that a vehicle with a round chassis covers, m; 0 for other chassis.
double radius_of(std::span<const Part> vehicle);

/// The footprint of a solid with this frame of its middle. A box or prism that has tipped over gets
/// the smallest rectangle around its box, aligned with its heading.
Footprint footprint_of(const Shape& shape, const Frame& middle);
Footprint footprint_of(const Obstacle& obstacle);
/// The footprint of a vehicle whose wheels are `z` m above the floor: a disc for a round chassis.
Footprint footprint_of(std::span<const Part> vehicle, const Pose& pose, double z);
/// The footprints of a robot and of its segments in line behind it.
std::vector<Footprint> footprints_of(const BodyPlan& plan, const Pose& pose, double z);

/// Whether two footprints overlap by more than a micrometre, both in height and seen from above
/// (by the separating axis theorem).
bool overlap(const Footprint& a, const Footprint& b);

/// A sentence about `what` if the place is outside of the arena, else none.
std::optional<std::string> outside(const Arena& arena, const std::string& what, double x, double y);
/// The same for a footprint: its middle must be inside, and it must not overlap a wall.
std::optional<std::string> outside(const Arena& arena, const std::string& what,
                                   const Footprint& footprint);

}  // namespace elsie::world

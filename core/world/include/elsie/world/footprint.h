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

/// A rotated rectangle or a disc on the floor with a bottom and a top.
struct Footprint {
  double x = 0.0, y = 0.0;  // m, its middle
  double heading_rad = 0.0;
  double half_length = 0.0, half_width = 0.0;  // m, along the heading and across
  double bottom = 0.0, top = 0.0;              // m
  bool round = false;                          // a disc; its radius is half its length

  /// Its extent from its middle in a direction, a unit vector; m.
  double reach(double ux, double uy) const;
};

/// How far a vehicle reaches from its origin, m: ahead and behind, to either side, and upwards. Of
/// what reaches past its chassis by less than a nanometre, the chassis counts.
Vector3 extents_of(std::span<const Part> vehicle);
/// The radius of the disc on which a vehicle stands whose chassis is round, m; 0 for another one.
double radius_of(std::span<const Part> vehicle);

/// A solid whose middle is there. A box that has tipped over: the smallest rectangle in its heading
/// around it.
Footprint footprint_of(const Shape& shape, const Frame& middle);
Footprint footprint_of(const Box& box);
/// A vehicle, its wheels `z` m above the floor: a disc if its chassis is round.
Footprint footprint_of(std::span<const Part> vehicle, const Pose& pose, double z);
/// A robot, then its segments in line behind it.
std::vector<Footprint> footprints_of(const BodyPlan& plan, const Pose& pose, double z);

/// Whether they overlap by more than a micrometre, in height and seen from above (rectangles by the
/// separating axis theorem on their four axes).
bool overlap(const Footprint& a, const Footprint& b);

/// A sentence about `what` if the place is outside of the arena.
std::optional<std::string> outside(const Arena& arena, const std::string& what, double x, double y);
/// The same for a footprint: its middle must be inside, and it must not overlap a wall.
std::optional<std::string> outside(const Arena& arena, const std::string& what,
                                   const Footprint& footprint);

}  // namespace elsie::world

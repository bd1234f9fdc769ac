// Areas of bodies on the floor: whether they overlap, and whether they are in the arena.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/world/description.h"

namespace elsie::world {

/// A rotated rectangle on the floor with a bottom and a top.
struct Footprint {
  double x = 0.0, y = 0.0;  // m, its middle
  double heading_rad = 0.0;
  double half_length = 0.0, half_width = 0.0;  // m, along the heading and across
  double bottom = 0.0, top = 0.0;              // m

  /// Its extent from its middle in a direction, a unit vector; m.
  double reach(double ux, double uy) const;
};

/// A box at its start, and at its present frame, whose origin is in the middle of the box's bottom.
/// If the box has tipped over: the smallest rectangle in its heading around it.
Footprint footprint_of(const Box& box);
Footprint footprint_of(const Box& box, const Frame& now);
/// A robot without its segments, its wheels `z` m above the floor.
Footprint footprint_of(const RobotBody& body, const Pose& pose, double z);
Footprint footprint_of(const Segment& segment, const Pose& pose, double z);
/// One vehicle of a body, at its pose.
Footprint footprint_of(const BodyPlan& plan, std::size_t vehicle, const Pose& pose, double z);
/// All vehicles of a body (plan_of()) in line behind the first.
std::vector<Footprint> footprints_of(const BodyPlan& plan, const Pose& pose, double z);

/// Whether they overlap by more than a micrometre, in height and by the separating axis theorem on
/// the four axes of the two rectangles.
bool overlap(const Footprint& a, const Footprint& b);

/// A sentence about `what` if the place is outside of the arena.
std::optional<std::string> outside(const Arena& arena, const std::string& what, double x, double y);
/// The same for a footprint: its middle must be inside, and it must not overlap a wall.
std::optional<std::string> outside(const Arena& arena, const std::string& what,
                                   const Footprint& footprint);

}  // namespace elsie::world

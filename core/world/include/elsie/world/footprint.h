// What stands on the floor, seen from above: whether there is room for it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/world/description.h"

namespace elsie::world {

/// What something covers: a turned rectangle on the floor, from a bottom to a top.
struct Footprint {
  double x = 0.0, y = 0.0;  // m, its middle
  double heading_rad = 0.0;
  double half_length = 0.0, half_width = 0.0;  // m, along the heading and across
  double bottom = 0.0, top = 0.0;              // m

  /// How far it reaches from its middle along a direction, a unit vector; m.
  double reach(double ux, double uy) const;
};

/// A box as the world describes it, and one that is somewhere else by now: of one that has tipped
/// over, the rectangle in its heading that holds it. The frame's origin is in the middle of its
/// bottom.
Footprint footprint_of(const Box& box);
Footprint footprint_of(const Box& box, const Frame& now);
/// A robot without what it pulls, its wheels `z` m above the floor.
Footprint footprint_of(const RobotBody& body, const Pose& pose, double z);
Footprint footprint_of(const Segment& segment, const Pose& pose, double z);
/// A robot, then its segments in line behind it.
std::vector<Footprint> footprints_of(const RobotBody& body, std::span<const Segment> segments,
                                     const Pose& pose, double z);

/// Whether they overlap by more than a micrometre: by the separating axis theorem, on the four axes
/// of the two rectangles, where their heights do.
bool overlap(const Footprint& a, const Footprint& b);

/// A sentence about `what` when the place is outside of the arena; none when it is inside.
std::optional<std::string> outside(const Arena& arena, const std::string& what, double x, double y);
/// The same for something with a size, whose middle must be inside, and which must not reach into a
/// wall.
std::optional<std::string> outside(const Arena& arena, const std::string& what,
                                   const Footprint& footprint);

}  // namespace elsie::world

// The colours of teams and resources, for pictures from above and for what cameras see.
#pragma once

#include <string_view>

#include "elsie/world/description.h"

namespace elsie::world {

// The two teams of every world.
inline constexpr Colour kRedTeam{0xd0, 0x30, 0x30};
inline constexpr Colour kBlueTeam{0x30, 0x60, 0xd0};

/// A resource that belongs to no team: a green whose hue is far from those of the two teams and
/// from the yellow of chargers.
inline constexpr Colour kResourceOfNoTeam{0x2e, 0x9e, 0x4f};

/// The colour of chargers of any team.
inline constexpr Colour kChargerColour{0xff, 0xd0, 0x00};

/// The colour of everything else without a team: a grey.
inline constexpr Colour kNoTeam{0x6b, 0x72, 0x7a};

/// Gives a colour to every team without one. "red" and "blue" get red and blue. The other teams, in
/// their order, get equally bright and saturated colours. Each hue is in the middle of the widest
/// gap between all hues used so far (of equal gaps, the one with the lowest hue): hues of teams,
/// boxes, resources without a team and chargers, present or not. The result is deterministic.
void colour_teams(World& world);

/// The colour of a team: the one in the world, else that of "red" or "blue", else kNoTeam.
Colour team_colour(const World& world, std::string_view team);

/// The colour of a robot's chassis: its own, else its team's.
Colour robot_colour(const World& world, const Robot& robot);

/// The colour of a resource in full light: its own, else its team's, else kResourceOfNoTeam.
Colour resource_colour(const World& world, const Obstacle& resource);

/// The colours of boxes that have none of their own, by kind.
struct BoxColours {
  Colour fixed, dynamic, moving;
};
/// What cameras and other sensors see of walls and of boxes without a colour.
inline constexpr Colour kSeenWall{130, 130, 130};
inline constexpr BoxColours kSeenBoxes{{115, 115, 115}, {85, 85, 85}, {70, 70, 70}};
/// The colour of a box in full light: its own, else resource_colour() for a resource, else the
/// colour of its kind.
Colour box_colour(const World& world, const Obstacle& obstacle, const BoxColours& otherwise);

}  // namespace elsie::world

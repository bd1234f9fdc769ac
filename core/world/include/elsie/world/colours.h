// The colours of teams and resources, for pictures from above and for what cameras see.
#pragma once

#include <string_view>

#include "elsie/world/description.h"

namespace elsie::world {

// The two teams of every world.
inline constexpr Colour kRedTeam{0xd0, 0x30, 0x30};
inline constexpr Colour kBlueTeam{0x30, 0x60, 0xd0};

/// A resource of no team: a green, far from the hues of both teams and of chargers.
inline constexpr Colour kResourceOfNoTeam{0x2e, 0x9e, 0x4f};

/// The colour of chargers of any team, and, a grey, that of everything else without a team.
inline constexpr Colour kChargerColour{0xff, 0xd0, 0x00};
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

/// The colours of walls, of tyres and, by kind, of boxes that have none of their own.
struct Colours {
  Colour wall, tyre, fixed, dynamic, moving;
};
/// To cameras and other sensors: greys.
inline constexpr Colours kSeen{
    {130, 130, 130}, {25, 25, 25}, {115, 115, 115}, {85, 85, 85}, {70, 70, 70}};
/// To people: a light room, in which the colours of teams stand out.
inline constexpr Colours kShown{
    {201, 205, 210}, {32, 32, 32}, {168, 157, 144}, {217, 180, 108}, {157, 131, 184}};

/// The colour of a box in full light: its own, that of a resource, or that of its kind.
Colour box_colour(const World& world, const Obstacle& obstacle, const Colours& otherwise);

}  // namespace elsie::world

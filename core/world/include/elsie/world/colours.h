// The colours of teams and resources, for pictures from above and for what cameras see.
#pragma once

#include <string_view>

#include "elsie/world/description.h"

namespace elsie::world {

// The two teams that every world has by itself.
inline constexpr Colour kRedTeam{0xd0, 0x30, 0x30};
inline constexpr Colour kBlueTeam{0x30, 0x60, 0xd0};

/// A resource that belongs to no team: a green whose hue is far from those of the two teams and
/// from the yellow of chargers.
inline constexpr Colour kResourceOfNoTeam{0x2e, 0x9e, 0x4f};

/// Chargers, whose ever they are.
inline constexpr Colour kChargerColour{0xff, 0xd0, 0x00};

/// What belongs to no team otherwise: a grey.
inline constexpr Colour kNoTeam{0x6b, 0x72, 0x7a};

/// Gives a colour to every team that has none, as reading a file does: "red" and "blue" get theirs,
/// any other one as bright and saturated as theirs with the hue that is farthest from all hues in
/// the world until then: the middle of the widest gap between them, of equal gaps the one of the
/// lowest hue. In the world are the colours of teams, boxes, resources of no team and chargers,
/// whether there are such or not. In the order of the teams; the same world gives the same colours.
void colour_teams(World& world);

/// The colour of a team: what the world says, else that of the two teams that are there by
/// themselves, else kNoTeam.
Colour team_colour(const World& world, std::string_view team);

/// The colour of a resource in full light: its own, else its team's, else kResourceOfNoTeam.
Colour resource_colour(const World& world, const Box& resource);

/// The colours of boxes that have none of their own, by kind.
struct BoxColours {
  Colour fixed, dynamic, moving;
};
/// The colour of a box in full light: its own, for a resource that of resource_colour(), else that
/// of its kind.
Colour box_colour(const World& world, const Box& box, const BoxColours& otherwise);

}  // namespace elsie::world

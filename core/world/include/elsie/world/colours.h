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

/// What belongs to no team otherwise: a grey.
inline constexpr Colour kNoTeam{0x6b, 0x72, 0x7a};

/// The colour of a team: what the world says, else that of the two teams that are there by
/// themselves, else kNoTeam.
Colour team_colour(const World& world, std::string_view team);

/// The colour of a resource in full light: its own, else its team's, else kResourceOfNoTeam.
Colour resource_colour(const World& world, const Box& resource);

}  // namespace elsie::world

#include "elsie/world/colours.h"

namespace elsie::world {

Colour team_colour(const World& world, std::string_view team) {
  for (const Team& known : world.teams) {
    if (known.id == team) {
      return known.colour;
    }
  }
  return team == "red" ? kRedTeam : team == "blue" ? kBlueTeam : kNoTeam;
}

Colour resource_colour(const World& world, const Box& resource) {
  if (resource.colour) {
    return *resource.colour;
  }
  return resource.team.empty() ? kResourceOfNoTeam : team_colour(world, resource.team);
}

}  // namespace elsie::world

#include "elsie/world/colours.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace elsie::world {

namespace {

// A colour counts as a grey, which has no hue, if its channels differ by less than this.
constexpr int kLeastChroma = 24;

/// The hue of a colour in degrees, in [0, 360), by the usual hexcone model (Smith 1978). A grey has
/// none.
std::optional<double> hue_deg(const Colour& c) {
  const int high = std::max({c.red, c.green, c.blue}), low = std::min({c.red, c.green, c.blue});
  const double chroma = high - low;
  if (chroma < kLeastChroma) return std::nullopt;
  const double hue = high == c.red     ? 60.0 * (c.green - c.blue) / chroma
                     : high == c.green ? 120.0 + 60.0 * (c.blue - c.red) / chroma
                                       : 240.0 + 60.0 * (c.red - c.green) / chroma;
  return hue < 0.0 ? hue + 360.0 : hue;
}

/// The colour of this hue with the brightness and saturation of the red team's colour.
Colour of_hue(double hue) {
  const double low = kRedTeam.blue, high = kRedTeam.red;
  const auto channel = [&](double middle) {
    const double off = std::abs(std::remainder(hue - middle, 360.0));  // from 0 to 180
    const double part = std::clamp(2.0 - off / 60.0, 0.0, 1.0);
    return static_cast<std::uint8_t>(std::lround(low + part * (high - low)));
  };
  return {channel(0.0), channel(120.0), channel(240.0)};
}

/// The middle of the widest gap on the circle. `hues` must be ascending and not empty.
double farthest_from(const std::vector<double>& hues) {
  double widest = 0.0, middle = 0.0;
  for (std::size_t i = 0; i < hues.size(); ++i) {
    const double next = i + 1 < hues.size() ? hues[i + 1] : hues.front() + 360.0;
    if (next - hues[i] > widest) {
      widest = next - hues[i];
      middle = hues[i] + 0.5 * widest;
    }
  }
  return std::fmod(middle, 360.0);
}

}  // namespace

void colour_teams(World& world) {
  std::vector<double> hues;
  const auto use = [&hues](const std::optional<Colour>& colour) {
    if (const auto hue = colour ? hue_deg(*colour) : std::nullopt) {
      hues.insert(std::lower_bound(hues.begin(), hues.end(), *hue), *hue);
    }
  };
  for (const Colour& colour : {kRedTeam, kBlueTeam, kResourceOfNoTeam, kChargerColour}) {
    use(colour);
  }
  for (const Obstacle& obstacle : world.obstacles) {
    use(obstacle.colour);
  }
  for (Team& team : world.teams) {
    if (!team.colour && (team.id == "red" || team.id == "blue")) {
      team.colour = team.id == "red" ? kRedTeam : kBlueTeam;
    }
    use(team.colour);
  }
  for (Team& team : world.teams) {
    if (!team.colour) {
      team.colour = of_hue(farthest_from(hues));
      use(team.colour);
    }
  }
}

Colour team_colour(const World& world, std::string_view team) {
  for (const Team& known : world.teams) {
    if (known.id == team && known.colour) return *known.colour;
  }
  return team == "red" ? kRedTeam : team == "blue" ? kBlueTeam : kNoTeam;
}

Colour robot_colour(const World& world, const Robot& robot) {
  return robot.colour ? *robot.colour : team_colour(world, robot.team);
}

Colour resource_colour(const World& world, const Obstacle& resource) {
  if (resource.colour) return *resource.colour;
  return resource.team.empty() ? kResourceOfNoTeam : team_colour(world, resource.team);
}

Colour box_colour(const World& world, const Obstacle& obstacle, const Colours& otherwise) {
  if (obstacle.kind == ObstacleKind::resource) return resource_colour(world, obstacle);
  return obstacle.colour.value_or(obstacle.kind == ObstacleKind::fixed     ? otherwise.fixed
                                  : obstacle.kind == ObstacleKind::dynamic ? otherwise.dynamic
                                                                           : otherwise.moving);
}

}  // namespace elsie::world

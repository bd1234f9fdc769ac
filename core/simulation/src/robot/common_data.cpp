#include "robot/common_data.h"

#include <algorithm>
#include <utility>

#include "elsie/base/error.h"
#include "elsie/base/near_name.h"
#include "elsie/world/colours.h"

#include "step/teams.h"

namespace elsie::simulation {

CommonData::CommonData(const world::World& world, std::shared_ptr<const RobotIds> ids)
    : ids_(std::move(ids)) {
  std::map<std::string_view, int> sizes;
  for (const world::Robot& robot : world.robots) {
    numbers_.push_back(sizes[robot.team]++);
  }
}

void CommonData::require_robot(const std::string& id) const {
  if (!ids_ || ids_->contains(id)) return;
  throw base::Error("it says a message to the robot '" + id + "', and there is no such robot" +
                    base::near_or_all(id, {ids_->begin(), ids_->end()}, "there are"));
}

const std::vector<Colour>& CommonData::resource_colours(const world::World& world,
                                                        const std::string& team) {
  const auto [known, is_new] = colours_.try_emplace(team);
  std::vector<Colour>& colours = known->second;
  if (!is_new) return colours;
  for (const world::Obstacle& obstacle : world.obstacles) {
    if (may_collect(team, obstacle)) {
      const Colour colour = world::resource_colour(world, obstacle);
      if (std::find(colours.begin(), colours.end(), colour) == colours.end()) {
        colours.push_back(colour);
      }
    }
  }
  return colours;
}

const SensorPlace& CommonData::place(const Mounting& mounting) {
  const auto& [at, azimuth, pitch, segment] = mounting;
  const SensorPlace*& place =
      known_[{at.x, at.y, at.z, azimuth, pitch, static_cast<double>(segment)}];
  if (!place) {
    place = &places_.emplace_back(SensorPlace{mounting, Frame::turned(at, azimuth, pitch)});
  }
  return *place;
}

}  // namespace elsie::simulation

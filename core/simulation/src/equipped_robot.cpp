#include "elsie/simulation/equipped_robot.h"

#include <stdexcept>

#include "step/commons.h"
#include "step/robot.h"

namespace elsie::simulation {

EquippedRobot::EquippedRobot(const world::World& world, std::size_t robot,
                             const plugin::Host& host) {
  Commons commons(world);
  robot_ = std::make_unique<Robot>(world, robot, commons, host, Options{});
}
EquippedRobot::EquippedRobot(EquippedRobot&&) noexcept = default;
EquippedRobot::~EquippedRobot() = default;

Component& EquippedRobot::object(const world::PluginUse& use) {
  const PluginObject* const found = robot_->find_object(use);
  if (!found) {
    throw std::invalid_argument("the plugin '" + use.plugin + "' is not part of the robot '" +
                                robot_->description().id + "'");
  }
  return *found->held;
}

}  // namespace elsie::simulation

#include "elsie/simulation/equipped_robot.h"

#include <stdexcept>

#include "step/robot.h"

namespace elsie::simulation {

class EquippedRobot::Impl {
 public:
  Impl(const world::World& world, std::size_t index, const plugin::Host& host)
      : robot(world.robots[index], Robot::membership(world, index), host, Options{}) {}

  Robot robot;
};

EquippedRobot::EquippedRobot(const world::World& world, std::size_t robot, const plugin::Host& host)
    : impl_(std::make_unique<Impl>(world, robot, host)) {}
EquippedRobot::EquippedRobot(EquippedRobot&&) noexcept = default;
EquippedRobot::~EquippedRobot() = default;

Component& EquippedRobot::object(const world::PluginUse& use) {
  const std::optional<TunedObject> found = impl_->robot.find_object(use);
  if (!found) {
    throw std::invalid_argument("the plugin '" + use.plugin + "' is no part of the robot '" +
                                impl_->robot.description().id + "'");
  }
  return *found->object;
}

}  // namespace elsie::simulation

#include "elsie/simulation/equipped_robot.h"

#include "robot/common_data.h"
#include "robot/robot.h"

namespace elsie::simulation {

EquippedRobot::EquippedRobot(const world::World& world, std::size_t robot, const plugin::Host& host)
    : robot_(std::make_unique<Robot>(world, robot, std::make_shared<CommonData>(world), host,
                                     Options{})) {}
EquippedRobot::EquippedRobot(EquippedRobot&&) noexcept = default;
EquippedRobot::~EquippedRobot() = default;

Component& EquippedRobot::object(const world::PluginUse& use) { return robot_->object(use); }

}  // namespace elsie::simulation

// A robot by itself, as it is before a run: for who wants to look at its plugin objects, or to have
// one of them learn, without a simulation around it.
//
//   simulation::EquippedRobot robot(world, 0, host);
//   auto& coordinator = robot.object(*world.robots[0].coordinator);
#pragma once

#include <cstddef>
#include <memory>

#include "elsie/api/component.h"
#include "elsie/plugin/host.h"
#include "elsie/world/description.h"

namespace elsie::simulation {

class Robot;

class EquippedRobot {
 public:
  /// Makes the plugin objects of the robot of this index and equips them with what it has in this
  /// world, all as Simulation does it before it resets them: body, sensors, place in its team, the
  /// charger nearest to where it starts. There is no physics, and no camera is looked through. The
  /// world and the host must stay where they are for as long as the robot lives. Throws
  /// world::WorldError when a plugin refuses its parameters or the robot.
  EquippedRobot(const world::World& world, std::size_t robot, const plugin::Host& host);
  EquippedRobot(EquippedRobot&&) noexcept;
  ~EquippedRobot();

  /// The object that a sensor, behaviour or coordinator of this robot stands for, at any depth.
  /// Throws std::invalid_argument when `use` is no part of the robot in the world given.
  Component& object(const world::PluginUse& use);

 private:
  std::unique_ptr<Robot> robot_;
};

}  // namespace elsie::simulation

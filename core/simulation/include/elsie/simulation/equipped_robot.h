// A robot without a simulation, in its state before a run. Use it to look at plugin objects, or to
// train one of them.
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
  /// Makes and equips the plugin objects of the robot with this index, as Simulation does before it
  /// resets them: body, sensors, team index, the charger nearest to its start. There is no physics,
  /// and cameras take no pictures. The world and the host must outlive the robot and must not move.
  /// Throws world::WorldError when a plugin refuses its parameters or the robot.
  EquippedRobot(const world::World& world, std::size_t robot, const plugin::Host& host);
  EquippedRobot(EquippedRobot&&) noexcept;
  ~EquippedRobot();

  /// The object of a sensor, behaviour or coordinator of this robot, at any depth. Throws
  /// std::invalid_argument when `use` is not part of this robot in the given world.
  Component& object(const world::PluginUse& use);

 private:
  std::unique_ptr<Robot> robot_;
};

}  // namespace elsie::simulation

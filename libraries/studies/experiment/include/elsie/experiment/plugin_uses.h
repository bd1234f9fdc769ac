// The plugins that a world uses, including nested ones.
#pragma once

#include "elsie/api/declaration.h"
#include "elsie/world/description.h"

namespace elsie::experiment {

/// Calls see(PluginKind, use) for each behaviour and coordinator, at every depth. `Coordination` is
/// a world::Coordination, perhaps const.
template <class Coordination, class See>
void for_each_use_in(Coordination& coordination, const See& see) {
  for (auto& behavior : coordination.behaviors) {
    see(PluginKind::behavior, behavior);
    for (auto& inside : behavior.inside) {
      for_each_use_in(inside, see);
    }
  }
  if (coordination.coordinator) {
    see(PluginKind::coordinator, *coordination.coordinator);
  }
}

/// Calls see(PluginKind, use) for each plugin, in the order of the world. `World` is a
/// world::World, perhaps const.
template <class World, class See>
void for_each_use(World& world, const See& see) {
  for (auto& robot : world.robots) {
    for (auto& sensor : robot.sensors) {
      see(PluginKind::sensor, sensor);
    }
    for (auto& actuator : robot.actuators) {
      see(PluginKind::actuator, actuator);
    }
    for_each_use_in(robot, see);
    if (robot.drive) {
      see(PluginKind::drive, *robot.drive);
    }
    if (robot.localisation) {
      see(PluginKind::localisation, *robot.localisation);
    }
  }
  for (auto& measure : world.measures) {
    see(PluginKind::measure, measure);
  }
  for (auto& rule : world.rules) {
    see(PluginKind::rule, rule);
  }
}

}  // namespace elsie::experiment

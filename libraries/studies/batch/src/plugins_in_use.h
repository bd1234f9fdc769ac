// The plugins that a world uses, including nested ones.
#pragma once

#include "elsie/api/declaration.h"
#include "elsie/world/description.h"

namespace elsie::batch {

template <class See>
void for_each_use(world::Coordination& coordination, const See& see) {
  for (world::BehaviorUse& behavior : coordination.behaviors) {
    see(PluginKind::behavior, behavior);
    for (world::Coordination& inside : behavior.inside) {
      for_each_use(inside, see);
    }
  }
  if (coordination.coordinator) {
    see(PluginKind::coordinator, *coordination.coordinator);
  }
}

/// Calls see(PluginKind, world::PluginUse&) for each plugin, in the order of the world.
template <class See>
void for_each_use(world::World& world, const See& see) {
  for (world::Robot& robot : world.robots) {
    for (world::SensorUse& sensor : robot.sensors) {
      see(PluginKind::sensor, sensor);
    }
    for_each_use(static_cast<world::Coordination&>(robot), see);
    if (robot.drive) {
      see(PluginKind::drive, *robot.drive);
    }
  }
  for (world::PluginUse& measure : world.measures) {
    see(PluginKind::measure, measure);
  }
}

}  // namespace elsie::batch

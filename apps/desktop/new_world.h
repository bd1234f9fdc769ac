// A new world, in which a robot succeeds.
#pragma once

#include <QString>

namespace elsie::desktop {

/// The text of a world that runs at once: a robot with sensors, behaviours and a coordinator
/// collects four resources in less than a minute of simulated time, with any seed.
QString new_world();

}  // namespace elsie::desktop

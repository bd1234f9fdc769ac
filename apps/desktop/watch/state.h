// Reads the `state` events of a session.
#pragma once

#include "engine/json.h"

namespace elsie::desktop {

/// The robot of a state, or null.
const Json& robot_of(const Json& state, const QString& id);

}  // namespace elsie::desktop

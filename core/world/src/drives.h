// The bodies of robots whose worlds name a drive.
#pragma once

#include "reading.h"

namespace elsie::world {

/// Asks the drives for the parts of their robots and sets Robot::driven. A problem for each that
/// does not fit its chassis or makes an impossible body.
void build_bodies(Reading& reading, const plugin::Host& host, Problems& problems);

}  // namespace elsie::world

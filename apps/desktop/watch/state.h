// Reads the `state` events of a session.
#pragma once

#include <vector>

#include "engine/json.h"

namespace elsie::desktop {

/// The robot of a state, or null.
const Json& robot_of(const Json& state, const QString& id);

/// Parts in [0, 1] as whole percents that add up to the rounded sum of the parts, 100 for those of
/// a whole: the largest remainders are rounded up. Parts that are not finite count as 0.
std::vector<int> whole_percents(const std::vector<double>& parts);

}  // namespace elsie::desktop

// What plugins have to show, gathered for the result of a run.
#pragma once

#include <string>
#include <vector>

#include "elsie/api/component.h"
#include "elsie/simulation/run_result.h"
#include "elsie/world/description.h"

#include "plugins/guard.h"

namespace elsie::simulation {

/// Appends the curves of a plugin object. `plugin`: what it is called in the result. Throws
/// PluginFault.
void append_curves(const Component& object, const world::PluginUse& use, const std::string& robot,
                   const std::string& plugin, Guard& guard, std::vector<LearningCurve>& curves);

}  // namespace elsie::simulation

// What plugin objects say once they are reset, gathered for the result of a run.
#pragma once

#include <string>
#include <vector>

#include "elsie/api/component.h"
#include "elsie/simulation/run_result.h"
#include "elsie/world/description.h"

#include "plugins/guard.h"

namespace elsie::simulation {

struct Statements {
  std::vector<Note> notes;
  std::vector<LearningCurve> curves;

  /// Asks a plugin object of the guard's robot, or a measure. `path`: what stands before the
  /// object's id where it is inside a behaviour, "explore/", else "". Throws PluginFault.
  void ask(const Component& object, const world::PluginUse& use, const std::string& path,
           Guard& guard);
};

}  // namespace elsie::simulation

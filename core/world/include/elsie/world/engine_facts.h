// What worlds know of physics engines.
#pragma once

#include <string>
#include <vector>

#include "elsie/base/problems.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// The function that the library of an engine exports as `elsie_engine_parameters`: sets the list
/// to the attributes of <physics> that not every engine has, made by Describe for a struct of its
/// own. Physics::parameters has the values that a file sets. A name means the same in all engines.
using EngineParameters = void (*)(std::vector<AttributeSpec>& parameters);

/// The parameters of an engine; none if its library cannot be loaded.
std::vector<AttributeSpec> engine_parameters(const std::string& engine);

/// The function that the library of an engine exports as `elsie_check_world`: adds a problem for
/// everything in the world that the engine cannot simulate.
using EngineCheck = void (*)(const World& world, base::Problems& problems);

}  // namespace elsie::world

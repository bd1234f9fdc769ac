// What worlds know of physics engines.
#pragma once

#include <string>
#include <vector>

#include "elsie/base/problems.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// The highest speed at which overlapping bodies are pushed apart, m/s.
inline constexpr double kMaxCorrectingSpeed = 0.5;

/// The function that the library of an engine exports as `elsie_engine_parameters`: sets the list
/// to the attributes of <physics> that not every engine has, made by Describe for a struct of its
/// own. The values that a file sets are in Physics::parameters; their setters bring them into that
/// struct. Engines that declare a parameter of the same name mean the same by it.
using EngineParameters = void (*)(std::vector<AttributeSpec>& parameters);

/// The parameters of one engine. None if its library cannot be loaded, which is reported where a
/// world uses it.
std::vector<AttributeSpec> engine_parameters(const std::string& engine);
/// Those of all engines, each once, as attributes of Physics.
std::vector<AttributeSpec> engine_parameters();
/// The engines that have a parameter of this name.
std::vector<std::string> engines_with(const std::string& parameter);

/// The function that the library of an engine exports as `elsie_check_world`: adds a problem for
/// everything in the world that the engine cannot simulate.
using EngineCheck = void (*)(const World& world, base::Problems& problems);

}  // namespace elsie::world

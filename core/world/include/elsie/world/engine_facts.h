// What worlds know of physics engines.
#pragma once

#include "elsie/base/problems.h"

namespace elsie::world {

struct World;

/// The highest speed at which overlapping bodies are pushed apart, m/s.
inline constexpr double kMaxCorrectingSpeed = 0.5;

/// The function that the library of an engine exports as `elsie_check_world`: adds a problem for
/// everything in the world that the engine cannot simulate.
using EngineCheck = void (*)(const World& world, base::Problems& problems);

}  // namespace elsie::world

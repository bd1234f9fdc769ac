#include "elsie/physics/engine.h"
#include "elsie/plugin/engine_libraries.h"

namespace elsie::physics {

std::unique_ptr<Engine> make_engine(const world::Arena& arena, const world::Physics& physics) {
  const auto make =
      reinterpret_cast<EngineEntry>(plugin::engine_symbol(physics.engine, "elsie_make_engine"));
  return std::unique_ptr<Engine>(make(arena, physics));
}

}  // namespace elsie::physics

#include "elsie/physics/engine.h"
#include "elsie/plugin/engine_libraries.h"
#include "elsie/plugin/error.h"

namespace elsie::physics {

std::unique_ptr<Engine> make_engine(const world::Arena& arena, const world::Physics& physics) {
  const auto* const interface = static_cast<const EngineInterface*>(
      plugin::engine_symbol(physics.engine, "elsie_engine_interface"));
  if (*interface != EngineInterface()) {
    throw plugin::PluginError("the physics engine '" + physics.engine + "', " +
                                  plugin::engine_file(physics.engine).string() +
                                  ", is of another version of Elsie; reinstall Elsie, or build "
                                  "it again",
                              base::kOtherFailure);
  }
  const auto make =
      reinterpret_cast<EngineEntry>(plugin::engine_symbol(physics.engine, "elsie_make_engine"));
  return std::unique_ptr<Engine>(make(arena, physics));
}

}  // namespace elsie::physics

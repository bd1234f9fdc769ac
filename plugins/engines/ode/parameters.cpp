// What ODE's softness of contacts and joints is in a world file.
#include <vector>

#include "softness.h"

extern "C" __attribute__((visibility("default"))) void elsie_engine_parameters(
    std::vector<elsie::world::AttributeSpec>& parameters) {
  parameters = elsie::physics::softness_parameters();
}

extern "C" __attribute__((visibility("default"))) void elsie_check_world(
    const elsie::world::World& world, elsie::base::Problems& problems) {
  elsie::physics::check_softness(world.physics, problems);
}

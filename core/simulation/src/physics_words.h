// Notes and errors about the physics.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "elsie/physics/engine.h"
#include "elsie/physics/failure.h"
#include "elsie/simulation/fault.h"
#include "elsie/simulation/run_result.h"
#include "elsie/world/description.h"

namespace elsie::simulation {

/// Appends a note for each setting of the world that is difficult for the physics.
void note_warnings(const world::World& world, std::vector<Note>& notes);
/// The same after an edit, without the notes that exist already.
void note_new_warnings(const world::World& world, double time_s, std::vector<Note>& notes);
/// Appends a note if the solver gave up in some of the steps.
void note_give_ups(const world::World& world, const physics::GiveUps& give_ups, std::uint64_t steps,
                   std::vector<Note>& notes);
/// The fault for a failure in this step, with the name of the body in the world.
PhysicsFault fault_of(const world::World& world, const physics::Failure& failure,
                      std::uint64_t step);

}  // namespace elsie::simulation

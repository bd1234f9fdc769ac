// How the planar engine describes a vehicle's parts.
#pragma once

#include <span>
#include <vector>

#include "elsie/api/body.h"
#include "elsie/world/description.h"

#include "mover.h"
#include "outline.h"

namespace elsie::physics {

/// A prism of a body.
struct Solid {
  Outline outline;
  Vector2 place;    // of its middle, in the body's frame
  Direction ahead;  // in the body's frame
  bool is_wheel = false;
  bool below = false;  // below the chassis and within its outline: only low bodies meet it
};

/// The chassis, and wheels and casters that something can meet before the chassis.
std::vector<Solid> solids_of(std::span<const Part> vehicle);

Inertia inertia_of(std::span<const Part> vehicle);

/// The weight on each part, N: what wheels, casters and the joint with the vehicle in front carry
/// if all of them give way alike. A vehicle without wheels lies on its chassis.
std::vector<double> loads_of(std::span<const Part> vehicle, const Inertia& inertia, double gravity);

Mover mover_of(std::span<const Part> vehicle, const world::Physics& physics);

/// The mean distance of an outline's corners from its middle, m; for a disc its radius.
double lever_of(const Outline& outline);

}  // namespace elsie::physics

// A prism as ODE's collision detection and solver need it.
#pragma once

#include <vector>

#include "ode_handles.h"
#include "outlines.h"

namespace elsie::physics {

/// ODE keeps pointers to the arrays of a convex body, so they live here; moving it keeps them.
struct ConvexArrays {
  std::vector<dReal> planes;  // normal and distance of each face
  std::vector<dReal> points;
  std::vector<unsigned> faces;  // number of corners, then their indices, counter-clockwise
};

/// The geometry of an upright prism about its middle.
OdeGeom make_prism(Corners outline, double half_height, ConvexArrays& arrays);

/// The mass of a prism about its middle, with an outline about the center of its area.
dMass prism_mass(Corners outline, double height, double mass);

}  // namespace elsie::physics

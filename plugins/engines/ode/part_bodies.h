// What shapes and parts of vehicles are for ODE.
#pragma once

#include "elsie/api/body.h"

#include "ode_handles.h"
#include "solids.h"

namespace elsie::physics {

/// ODE keeps pointers to the arrays of a convex body, so they live here; moving it keeps them.
struct ConvexArrays {
  std::vector<dReal> planes;  // normal and distance of each face
  std::vector<dReal> points;
  std::vector<unsigned> faces;  // number of corners, then their indices, counter-clockwise
};

dBodyID make_body(dWorldID world, dGeomID geom, const dMass& mass);
/// `arrays`: to be kept as long as the geometry.
OdeGeom make_geom(const Shape& shape, ConvexArrays& arrays);
/// Lays the geometry of a body along the axis of its shape.
void lay(dGeomID geom, const Shape& shape);
dMass mass_of(const Shape& shape, double mass);
void set_rotation(dBodyID body, const Frame& frame);
void stop(dBodyID body);
SolidKind kind_of(const Shape& shape);

}  // namespace elsie::physics

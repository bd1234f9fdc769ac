// What ODE needs of the parts of a vehicle.
#pragma once

#include "elsie/api/body.h"

#include "ode_handles.h"
#include "vehicle.h"

namespace elsie::physics {

dBodyID make_body(dWorldID world, dGeomID geom, const dMass& mass);
OdeGeom make_geom(const Shape& shape);
/// Lays the geometry of a body along the axis of its shape.
void lay(dGeomID geom, const Shape& shape);
dMass mass_of(const Part& part);
void set_rotation(dBodyID body, const Frame& frame);
void stop(dBodyID body);
SolidKind kind_of(const Shape& shape);

}  // namespace elsie::physics

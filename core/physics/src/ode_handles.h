// Owners of ODE's objects, and ODE's start in this process.
#pragma once

#include <memory>
#include <type_traits>

#include <ode/ode.h>

#include "elsie/api/geometry.h"

namespace elsie::physics {

/// Makes ODE ready for the calling thread; to be called before any other use of ODE in it.
void prepare_ode();

/// Steps the world. False if ODE's solver gave up: then the world has moved, but bodies may have
/// been let through their contacts.
bool step_ode(dWorldID world, double step);

inline Vector3 to_vector(const dReal* v) { return {v[0], v[1], v[2]}; }

struct DestroyOde {
  void operator()(dWorldID world) const { dWorldDestroy(world); }
  void operator()(dJointGroupID group) const { dJointGroupDestroy(group); }
  void operator()(dGeomID geom) const { dGeomDestroy(geom); }
};
/// A world owns its bodies and joints.
using OdeWorld = std::unique_ptr<std::remove_pointer_t<dWorldID>, DestroyOde>;
using OdeJointGroup = std::unique_ptr<std::remove_pointer_t<dJointGroupID>, DestroyOde>;
using OdeGeom = std::unique_ptr<std::remove_pointer_t<dGeomID>, DestroyOde>;

}  // namespace elsie::physics

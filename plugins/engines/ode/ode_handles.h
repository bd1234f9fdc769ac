// Owners of ODE's objects, and ODE's start in this process.
#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <type_traits>

#include <ode/ode.h>

#include "elsie/api/geometry.h"

#include "ode_threading.h"

namespace elsie::physics {

/// Prepares ODE for the calling thread; must be called before any other use of ODE in it.
void prepare_ode();

/// An error after which ODE cannot go on. ODE itself would end the process.
class OdeFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A world with its bodies and joints.
class OdeWorld {
 public:
  /// Steps with the threads of this pool, which must outlive the world.
  explicit OdeWorld(base::ThreadPool& pool);
  ~OdeWorld();
  OdeWorld(const OdeWorld&) = delete;
  OdeWorld& operator=(const OdeWorld&) = delete;

  dWorldID get() const { return world_; }

  /// Takes another pool.
  void work_with(base::ThreadPool& pool) { threading_.work_with(pool); }

  /// Takes a step of about so many islands. Returns false if ODE's solver gave up: the world has
  /// moved, but bodies may have passed through their contacts. Throws OdeFailure if it stopped half
  /// way; the world can then only be destroyed.
  bool step(double step, std::size_t islands);

 private:
  OdeThreading threading_;
  dWorldID world_;
};

inline Vector3 to_vector(const dReal* v) { return {v[0], v[1], v[2]}; }
inline bool is_finite(const Vector3& v) { return std::isfinite(v.x + v.y + v.z); }

struct DestroyOde {
  void operator()(dJointGroupID group) const { dJointGroupDestroy(group); }
  void operator()(dGeomID geom) const { dGeomDestroy(geom); }
  void operator()(dJointID joint) const { dJointDestroy(joint); }
};
using OdeJointGroup = std::unique_ptr<std::remove_pointer_t<dJointGroupID>, DestroyOde>;
using OdeJoint = std::unique_ptr<std::remove_pointer_t<dJointID>, DestroyOde>;
using OdeGeom = std::unique_ptr<std::remove_pointer_t<dGeomID>, DestroyOde>;

}  // namespace elsie::physics

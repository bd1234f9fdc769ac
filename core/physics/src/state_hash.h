// A hash over the states of bodies, by which two runs are compared.
#pragma once

#include "elsie/base/fnv1a.h"

#include "ode_handles.h"

namespace elsie::physics {

inline void add_numbers(base::Fnv1a& hash, const dReal* numbers, int count) {
  for (int i = 0; i < count; ++i) hash.add(numbers[i]);
}

inline void add_body(base::Fnv1a& hash, dBodyID body) {
  add_numbers(hash, dBodyGetPosition(body), 3);
  add_numbers(hash, dBodyGetQuaternion(body), 4);
  add_numbers(hash, dBodyGetLinearVel(body), 3);
  add_numbers(hash, dBodyGetAngularVel(body), 3);
}

}  // namespace elsie::physics

// Saved states of bodies, to repeat a step; and their hash, to compare two runs.
#pragma once

#include <vector>

#include "elsie/base/fnv1a.h"

#include "ode_handles.h"

namespace elsie::physics {

class BodyStates {
 public:
  void clear() { states_.clear(); }
  void add(dBodyID body);
  /// Puts every body back to where it was when it was added, with its velocities at that time.
  void restore() const;

 private:
  struct State {
    dBodyID body = nullptr;
    dReal position[3], orientation[4], velocity[3], turning[3];
  };
  std::vector<State> states_;
};

/// Gives a body exactly the place and velocities of another one, which may be in another world.
void copy_state(dBodyID from, dBodyID to);

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

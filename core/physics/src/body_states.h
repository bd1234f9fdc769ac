// The states of bodies before a step, to take it again.
#pragma once

#include <vector>

#include "ode_handles.h"

namespace elsie::physics {

class BodyStates {
 public:
  void clear() { states_.clear(); }
  void add(dBodyID body);
  /// Puts every body back to where it was when it was added, at the velocities of then.
  void restore() const;

 private:
  struct State {
    dBodyID body = nullptr;
    dReal position[3], orientation[4], velocity[3], turning[3];
  };
  std::vector<State> states_;
};

}  // namespace elsie::physics

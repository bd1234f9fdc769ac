#include "body_states.h"

#include <algorithm>

namespace elsie::physics {

void BodyStates::add(dBodyID body) {
  State& state = states_.emplace_back();
  state.body = body;
  std::copy_n(dBodyGetPosition(body), 3, state.position);
  std::copy_n(dBodyGetQuaternion(body), 4, state.orientation);
  std::copy_n(dBodyGetLinearVel(body), 3, state.velocity);
  std::copy_n(dBodyGetAngularVel(body), 3, state.turning);
}

void BodyStates::restore() const {
  for (const State& state : states_) {
    dBodySetPosition(state.body, state.position[0], state.position[1], state.position[2]);
    dBodySetQuaternion(state.body, state.orientation);
    dBodySetLinearVel(state.body, state.velocity[0], state.velocity[1], state.velocity[2]);
    dBodySetAngularVel(state.body, state.turning[0], state.turning[1], state.turning[2]);
  }
}

void copy_state(dBodyID from, dBodyID to) {
  const dReal *at = dBodyGetPosition(from), *turned = dBodyGetQuaternion(from);
  const dReal *v = dBodyGetLinearVel(from), *w = dBodyGetAngularVel(from);
  dBodySetPosition(to, at[0], at[1], at[2]);
  dBodySetQuaternion(to, turned);
  // ODE makes the quaternion's length 1 once more and a matrix of it, both with rounding.
  std::copy_n(turned, 4, const_cast<dReal*>(dBodyGetQuaternion(to)));
  std::copy_n(dBodyGetRotation(from), 12, const_cast<dReal*>(dBodyGetRotation(to)));
  dBodySetLinearVel(to, v[0], v[1], v[2]);
  dBodySetAngularVel(to, w[0], w[1], w[2]);
}

}  // namespace elsie::physics

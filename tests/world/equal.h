// Whether two worlds are the same but for the places where things stand in their files.
#pragma once

#include "elsie/world/same.h"

namespace elsie::test {

inline bool same(const world::World& a, const world::World& b) {
  return world::same(world::vocabulary(), &a, &b);
}

}  // namespace elsie::test

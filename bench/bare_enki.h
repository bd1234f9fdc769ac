// The same simulation on Enki, as an expert in Enki would write it, to compare the planar engine
// with.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>

#include "elsie/api/geometry.h"
#include "elsie/world/description.h"

#include "arena_of_robots.h"

namespace elsie::bench {

/// Differential-wheeled discs with eight beams of 1 m each in a walled square with fixed boxes.
/// Enki's own infra-red sensor casts three rays and models their response; a beam here is a local
/// interaction with a single ray, which is faster.
class BareEnki {
 public:
  /// One robot with the default body, as a disc of the same area, for each pose.
  BareEnki(std::span<const Pose> poses, std::span<const world::Obstacle> boxes,
           const world::Physics& physics, const world::Arena& arena, Rule rule);
  ~BareEnki();
  BareEnki(const BareEnki&) = delete;
  BareEnki& operator=(const BareEnki&) = delete;

  /// Beams, rule, motors, collisions and Enki's step.
  void step();
  Pose pose(std::size_t robot) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::bench

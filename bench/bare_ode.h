// The same simulation directly on ODE, as an expert in ODE would write it, to compare Elsie's
// engine with.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "elsie/api/geometry.h"
#include "elsie/world/description.h"

#include "arena_of_robots.h"

namespace elsie::bench {

/// Robots with eight range beams of 1 m each in a walled arena with fixed boxes. One hash space
/// holds the boxes, the walls and a simple space for each robot. Beams are ray geometries that are
/// tested against that space before every step.
class BareOde {
 public:
  static constexpr std::size_t kBeams = kBeamAzimuths_deg.size();

  /// One robot with the default body for each pose. Each robot has a beam in each azimuth (rad,
  /// from its heading), which starts on top of the chassis at its front edge.
  BareOde(std::span<const Pose> poses, std::span<const world::Obstacle> boxes,
          std::span<const double> azimuths, const world::Physics& physics,
          const world::Arena& arena, Rule rule);
  ~BareOde();
  BareOde(const BareOde&) = delete;
  BareOde& operator=(const BareOde&) = delete;

  /// Beams, rule, motors, contacts and ODE's step.
  void step();
  Pose pose(std::size_t robot) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::bench

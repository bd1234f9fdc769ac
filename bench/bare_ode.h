// The same simulation written directly on ODE, as someone who knows ODE would: what Elsie's engine
// is compared with.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>

#include "elsie/api/geometry.h"
#include "elsie/api/motor_command.h"
#include "elsie/world/description.h"

namespace elsie::bench {

/// Robots with eight range beams of 1 m each in a walled arena with fixed boxes. One hash space
/// holds the boxes, the walls and one simple space for each robot. Beams are ray geometries that
/// are collided with that space before every step.
class BareOde {
 public:
  static constexpr std::size_t kBeams = 8;
  static constexpr double kBeamRange = 1.0;  // m

  /// From the distances of the eight beams, `kBeamRange` where nothing is hit, to wheel rates.
  using Rule = std::function<MotorCommand(const double ranges[kBeams])>;

  /// As many robots of the default body as there are poses. A beam of each robot points in each
  /// azimuth (rad, from its heading) and starts at the front edge of the chassis, on its top.
  BareOde(std::span<const Pose> poses, std::span<const world::Box> boxes,
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

// Worlds with parameters at the ends of their allowed ranges, and their outcomes.
#pragma once

#include <cstdint>
#include <string>

#include "elsie/plugin/host.h"

namespace elsie::test {

/// The outcome of a world, as seen by an observer who checks the poses of robots and boxes after
/// each step, and knows nothing of the engine's own checks.
struct Extreme {
  std::string text;  // the world, XML
  double simulated_s = 0.0;
  bool warned = false;   // before it ran
  bool gave_up = false;  // in some step, and the notes say so
  std::string fault;     // the fault that ended the run; empty: none
  std::string seen;      // "robot 0 is 0.2 m below the floor at 0.35 s"; empty: all is well
  bool silent() const { return fault.empty() && !seen.empty(); }
};

/// Draws the world of this number and runs it for a thousand steps, at most 5 s. Each attribute of
/// the arena, of the physics, of robots' bodies and boxes keeps its default, or is drawn from its
/// allowed range: one of the two ends, or a value in between, uniformly in its logarithm. Worlds
/// that the reader refuses are drawn again.
Extreme run_extreme_world(std::uint64_t number, const plugin::Host& host);

}  // namespace elsie::test

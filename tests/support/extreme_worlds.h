// Worlds whose parameters stand at the ends of what is allowed, and what becomes of them.
#pragma once

#include <cstdint>
#include <string>

#include "elsie/plugin/host.h"

namespace elsie::test {

/// What became of a world, as somebody saw it who looked at the places of robots and boxes after
/// each step, and knew nothing of the engine's own checks.
struct Extreme {
  std::string text;  // the world, XML
  double simulated_s = 0.0;
  bool warned = false;   // before it ran
  bool gave_up = false;  // the solver did, in some step, and the notes say so
  std::string fault;     // what ended the run; empty: it ended by itself
  std::string seen;      // "robot 0 is 0.2 m below the floor at 0.35 s"; empty: all was well
  bool silent() const { return fault.empty() && !seen.empty(); }
};

/// Draws the world of this number and runs it for a thousand steps, at most 5 s. Each attribute of
/// the arena, of the physics, of robots' bodies and boxes keeps its default, or is drawn from the
/// range that the vocabulary allows: one of its two ends, or anything between, evenly in its
/// logarithm. What the reader refuses is drawn anew.
Extreme run_extreme_world(std::uint64_t number, const plugin::Host& host);

}  // namespace elsie::test

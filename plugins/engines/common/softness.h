// Parameters of engines: how fast they correct errors of contacts and joints, and how soft contacts
// are.
#pragma once

#include <vector>

#include "elsie/base/problems.h"
#include "elsie/world/description.h"
#include "elsie/world/vocabulary.h"

namespace elsie::physics {

/// ODE's two numbers for a constraint (Smith, "Open Dynamics Engine User Guide", 2006): where it is
/// off by the error e, a step of the length h gives it the relative velocity
///
///   J v = erp e / h - cfm f,
///
/// where f is the constraint's force: each step corrects the share erp of the error, and a force f
/// makes it give way at cfm f. A spring of the constant kp with the damping constant kd, integrated
/// implicitly, is such a constraint with
///
///   erp = h kp / (h kp + kd),  cfm = 1 / (h kp + kd).
struct Softness {
  double erp = 0.2;          // in (0, 1]
  double cfm = 1e-5;         // m/s per N; not negative
  bool from_spring = false;  // they follow from kp and kd
};

/// What the parameters of a world say, for its step.
Softness softness_of(const world::Physics& physics);

/// The parameters erp, cfm, kp and kd, as an engine exports them.
std::vector<world::AttributeSpec> softness_parameters();

/// The highest speed at which overlapping bodies are pushed apart, m/s.
inline constexpr double kMaxCorrectingSpeed = 0.5;

/// Adds a problem if only one of kp and kd is given, or erp or cfm besides both.
void check_softness(const world::Physics& physics, base::Problems& problems);

}  // namespace elsie::physics

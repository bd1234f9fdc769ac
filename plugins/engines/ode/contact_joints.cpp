#include "contact_joints.h"

#include <algorithm>

#include "softness.h"

namespace elsie::physics {
namespace {

// If a body has two contacts more than it needs, their softness distributes its weight.
constexpr double kLeastCfm = 1e-10;

// ODE's solver gives up where two contacts of the same body reach their limits at the same instant,
// as on symmetrical bodies. So two successive contacts are never quite equal.
constexpr std::size_t kTies = 7;

}  // namespace

ContactJoints::ContactJoints(dWorldID world, const world::Physics& physics)
    : world_(world),
      group_(dJointGroupCreate(0)),
      cfm_(std::max(softness_of(physics).cfm, kLeastCfm)) {}

void ContactJoints::finish(FoundContact& contact, std::size_t number) const {
  dSurfaceParameters& surface = contact.contact.surface;
  const double unequal = static_cast<double>(number % kTies);
  surface.soft_cfm = softer_ * cfm_ * (1.0 + 1e-3 * unequal);
  surface.mu *= 1.0 + 1e-6 * unequal;
  surface.mu2 *= 1.0 + 1e-6 * unequal;
}

void ContactJoints::join(const FoundContact& contact) {
  dJointAttach(dJointCreateContact(world_, group_.get(), &contact.contact), contact.a, contact.b);
}

void ContactJoints::clear(double softer) {
  dJointGroupEmpty(group_.get());
  softer_ = softer;
}

}  // namespace elsie::physics

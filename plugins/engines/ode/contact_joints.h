// Joints of the contacts of one step.
#pragma once

#include <cstddef>

#include "elsie/world/description.h"

#include "ode_contacts.h"
#include "ode_handles.h"

namespace elsie::physics {

/// Makes joints of contacts, which last for this step.
class ContactJoints {
 public:
  ContactJoints(dWorldID world, const world::Physics& physics);

  /// Completes a contact. `number`: how many contacts of the step precede it.
  void finish(FoundContact& contact, std::size_t number) const;
  /// Makes a joint of a contact that is complete.
  void join(const FoundContact& contact);
  /// Removes the joints of the step. Later contacts are `softer` times as soft.
  void clear(double softer = 1.0);

 private:
  dWorldID world_;
  OdeJointGroup group_;
  double cfm_;
  double softer_ = 1.0;
};

}  // namespace elsie::physics

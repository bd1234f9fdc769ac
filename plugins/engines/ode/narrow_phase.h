// Contacts between two bodies that may touch.
#pragma once

#include "ode_contacts.h"
#include "solids.h"

namespace elsie::physics {

// These make the contacts of two bodies, of which at least one can move, and return true if the
// bodies touch. Contacts across a gap do not count as touching.

bool meet_solids(OdeContacts& contacts, const Solid& a, const Solid& b);
bool meet_vehicles(OdeContacts& contacts, const Vehicle& a, const Vehicle& b);
bool meet_vehicle_and_box(OdeContacts& contacts, const Vehicle& vehicle, const Solid& box);

}  // namespace elsie::physics

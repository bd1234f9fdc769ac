// Contacts between two bodies that may touch.
#pragma once

#include "ode_contacts.h"
#include "vehicle.h"

namespace elsie::physics {

// These make the contacts of two bodies, at least one of which can give way, and say whether the
// bodies touch; contacts of bodies that still are a gap apart are not touches.

bool meet_solids(OdeContacts& contacts, const Solid& a, const Solid& b);
bool meet_vehicles(OdeContacts& contacts, const Vehicle& a, const Vehicle& b);
bool meet_vehicle_and_box(OdeContacts& contacts, const Vehicle& vehicle, const Solid& box);

}  // namespace elsie::physics

// A wheel, whole or tipped over, and the floor.
#pragma once

#include "ode_contacts.h"
#include "ode_handles.h"
#include "shapes.h"

namespace elsie::physics {

enum class WheelDrive { motor, free };

/// Makes the contact of a wheel, which is `geom` of `body` and sinks with `sinking` m/s, with the
/// floor.
void meet_floor(OdeContacts& contacts, dBodyID body, dGeomID geom, const Cylinder& wheel,
                double sinking, WheelDrive drive, dGeomID floor);

}  // namespace elsie::physics

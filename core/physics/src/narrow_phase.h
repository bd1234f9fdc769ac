// Contacts between two bodies that may touch.
#pragma once

#include "ode_contacts.h"
#include "ode_robot.h"
#include "shapes.h"

namespace elsie::physics {

enum class SolidKind { box, wheel };

/// One convex part of a body. Of a wheel `shape` is the box around it, with the axle along its
/// second axis.
struct Solid {
  dBodyID body = nullptr;  // none: it stands fast
  dGeomID geom = nullptr;
  SolidKind kind = SolidKind::box;
  OrientedBox shape;
};

// These make the contacts of two bodies, at least one of which can give way, and say whether the
// bodies touch; contacts of bodies that still are a gap apart are not touches.

bool meet_solids(OdeContacts& contacts, const Solid& a, const Solid& b);
bool meet_robots(OdeContacts& contacts, const OdeRobot& a, const OdeRobot& b);
bool meet_robot_and_box(OdeContacts& contacts, const OdeRobot& robot, const Solid& box);

}  // namespace elsie::physics

// Contacts of one step.
#pragma once

#include <span>
#include <vector>

#include "elsie/api/body.h"
#include "elsie/api/geometry.h"
#include "elsie/world/description.h"

#include "ode_handles.h"
#include "outlines.h"
#include "shapes.h"

namespace elsie::physics {

class Crowd;

/// Surfaces that are no further apart touch: a body that was stopped at a surface stands there, up
/// to rounding and the softness of contacts.
inline constexpr double kTouching = 2e-5;  // m

/// The impulse of a contact, noted by whatever solves it.
struct ContactImpulse {
  dJointFeedback joint{};        // if ODE does
  const Crowd* crowd = nullptr;  // that does otherwise, with these of its rows
  int first_row = 0, last_row = 0;
};

/// A contact in the form of ODE's joints. `b`, or `a`, is null for a fixed body. The members are
/// the data of the bodies, which Islands gives to them; null for a fixed body.
struct FoundContact {
  dBodyID a = nullptr;
  dBodyID b = nullptr;
  void* member_a = nullptr;
  void* member_b = nullptr;
  dContact contact{};
  ContactImpulse* impulse = nullptr;  // if somebody asks for it
};

/// Collects contacts of one step.
///
/// A contact may be made across a gap. It then only keeps the bodies from coming closer in this
/// step than to the surface. So a body at rest on the floor does not lose contact and fall back for
/// a step, and a fast body stops at a wall instead of inside it.
class OdeContacts {
 public:
  explicit OdeContacts(const world::Physics& physics);

  /// The gap, m, up to which a body that comes nearer at `speed` m/s needs a contact.
  double margin(double speed) const;

  /// A wheel, upright or tipped over, that is `geom` of `body` and sinks at `sinking` m/s. One
  /// without a motor rolls freely and only has grip sideways; one with rollers only has grip along
  /// their axles.
  void wheel_on_floor(dBodyID body, dGeomID geom, const Cylinder& wheel, double sinking,
                      const WheelJoint& joint, dGeomID floor);
  /// A sphere that slides on the floor without friction.
  void caster_on_floor(dBodyID caster, const Vector3& lowest);
  /// The points of a body that are on the floor or about to reach it; `box` is around it. Corners;
  /// the rims of a cylinder at their lowest points and at three more each, so that it can stand;
  /// the lowest points of balls.
  void solid_on_floor(dBodyID body, const Shape& shape, const OrientedBox& box);
  /// Two bodies, of which `b` is null if it is fixed. `normal` points from b into a.
  void between(dBodyID a, dBodyID b, const Vector3& point, const Vector3& normal, double gap);
  /// The same for a contact from one of ODE's colliders.
  void between(dBodyID a, dBodyID b, const dContactGeom& found);

  /// All contacts, in the order in which they were found.
  std::span<FoundContact> found() { return found_; }
  void clear() { found_.clear(); }

 private:
  static constexpr double kSlack = 1e-4;  // m

  double floor_reach(dBodyID body, const Vector3& half) const;
  void box_on_floor(dBodyID body, const OrientedBox& box);
  void prism_on_floor(dBodyID body, const OrientedBox& box, Corners outline);
  void rims_on_floor(dBodyID body, const Shape& shape, const OrientedBox& box, double highest);
  void attach(dBodyID a, dBodyID b, dContact& contact, double gap);
  void point_on_floor(dBodyID body, const Vector3& point, double highest);

  std::vector<FoundContact> found_;
  double step_;
  double gravity_;
  double friction_;
  double tyre_friction_;
  double slip_;
  double bounce_;
  double bounce_threshold_;  // m/s: bodies at rest must not hop
};

}  // namespace elsie::physics

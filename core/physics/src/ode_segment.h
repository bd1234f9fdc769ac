// The body of a segment in ODE.
#pragma once

#include <array>
#include <cstddef>

#include "elsie/physics/engine.h"
#include "elsie/world/description.h"
#include "elsie/world/train.h"

#include "ode_contacts.h"
#include "ode_handles.h"
#include "scene.h"
#include "vehicle.h"

namespace elsie::physics {

/// A box whose two passive wheels have neither mass nor spin of their own: each is a contact that
/// holds its place sideways and lets it roll freely. The wheels carry the box, and the universal
/// joint at its front keeps it level. Three points of support are never one too many, and the
/// solver has a dozen rows less for each segment than with wheels on hinges, none of which could
/// drift apart.
///
/// As with a robot's wheels the body in front is the master: after every step the segment is put
/// back to where its joint holds it, and turned no further than the joint's limits. It keeps its
/// velocity, unlike a wheel: it may be heavier than the robot, and a velocity that follows from the
/// robot's would add momentum from nowhere. ODE brings the velocities together in the next step.
class OdeSegment {
 public:
  OdeSegment(dWorldID world, const world::Segment& segment, const world::Coupling& coupling);

  /// Links it to the body in front; both stand where they belong.
  void link(dWorldID world, dBodyID front);
  /// Puts it in line behind a robot of this frame, at rest.
  void put(const Frame& robot);

  void meet_floor(OdeContacts& contacts, dGeomID floor) const;
  /// Before a step of this length. ODE notices a limit of a joint in the step after it was passed,
  /// which at 10 rad/s may be 10 degrees later; so the joint is stopped where the step would bring
  /// it past its limit.
  void stop_at_limit(double step);
  /// After a step: to where the joint, a point of the body in front, holds it. False if a number is
  /// not finite.
  bool settle(const Frame& front, const Vector3& joint);
  void place_in(Scene& scene, Scene::Id id, double step) const;

  const SegmentState& state() const { return state_; }
  dBodyID body() const { return body_; }
  const world::Coupling& coupling() const { return coupling_; }
  /// Where its joint is.
  Vector3 joint_place() const {
    return state_.frame.point({coupling_.ahead, 0.0, coupling_.height});
  }
  Vehicle vehicle() const;

 private:
  void limit_joint(const Frame& front);

  world::Segment dimensions_;
  world::Coupling coupling_;
  dBodyID body_ = nullptr;
  dJointID joint_ = nullptr;
  bool stopping_ = false;
  OdeGeom box_geom_;
  std::array<OdeGeom, 2> wheel_geoms_;
  SegmentState state_;
  Vector3 velocity_;
  Vector3 turning_;
  OrientedBox box_;
  std::array<Cylinder, 2> wheels_;
};

}  // namespace elsie::physics

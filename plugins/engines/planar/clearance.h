// How far bodies may move before they enter each other.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "contact_solver.h"
#include "pairing.h"
#include "planar_scene.h"

namespace elsie::physics {

/// A body of the engine: a wall, a box, or a vehicle of a robot. Its index is its id in the scene.
struct Collider {
  Body body;
  std::uint64_t number = 0;  // an engine that takes it over keeps it
  std::uint32_t mover = Contact::kFixed;
  std::uint32_t vehicle = 0;  // of a robot
  std::shared_ptr<const std::vector<Solid>> solids;
};

/// Keeps bodies apart whatever the contacts' impulses are.
///
/// Contacts know surfaces as they are at the beginning of a step. A body that turns far in the
/// step, or impulses that do not stop it, may lead it into another one. Then all bodies of its
/// island move only a part of their ways: until the first two would be deeper in each other than
/// kSlop, by conservative advancement (Mirtich, "Impulse-based Dynamic Simulation of Rigid Body
/// Systems", 1996). Their velocities stay, and the next step knows the surfaces where they are
/// then.
class Clearance {
 public:
  Clearance(const world::Physics& physics, const std::vector<Collider>& colliders,
            const std::vector<Mover>& movers, const PlanarScene& scene, const ContactSolver& solver)
      : physics_(physics), colliders_(colliders), movers_(movers), scene_(scene), solver_(solver) {}

  /// The part of its way in this step that an island can move, in [0, 1]. Its bodies have been
  /// entered and have their velocities. `kept`: at these, no point of a contact comes nearer than
  /// it may. `margin`: bodies that may come nearer by more than this have no contacts.
  double part(std::span<const std::uint32_t> bodies, std::span<const Contact> contacts, bool kept,
              double margin, PairingSpace& space) const;

  /// Where a body is at the beginning of the step.
  Placement placement(std::uint32_t collider) const {
    // Boxes that move along their own path are a little away from where the scene has them.
    const std::uint32_t mover = colliders_[collider].mover;
    return mover == Contact::kFixed
               ? Placement{scene_.place_of(collider), scene_.ahead_of(collider)}
               : Placement{movers_[mover].place(), movers_[mover].ahead()};
  }

 private:
  struct Pair {
    std::uint32_t a = 0, b = 0;  // colliders
    double gap = 0.0;            // m, at the beginning
  };
  double part(const Pair& pair, double most, PairingSpace& space) const;
  double gap(const Pair& pair, double part, double margin, PairingSpace& space) const;
  Placement placement(std::uint32_t collider, double part) const;

  const world::Physics& physics_;
  const std::vector<Collider>& colliders_;
  const std::vector<Mover>& movers_;
  const PlanarScene& scene_;
  const ContactSolver& solver_;
};

}  // namespace elsie::physics

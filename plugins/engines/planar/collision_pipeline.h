// From places and velocities to contacts, islands and impulses.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "elsie/base/thread_pool.h"
#include "elsie/physics/engine.h"

#include "clearance.h"
#include "contact_solver.h"
#include "mover.h"
#include "planar_scene.h"

namespace elsie::physics {

/// What happens between bodies in a step:
///
///   broad phase   find_contacts_of(): the scene's grid lists the bodies near each moving one
///   narrow phase  meet(): the outlines of two bodies meet at up to two points for each pair of
///                 their prisms (pairing.h), which become contacts
///   islands       order(): contacts and hinges link bodies that can be moved
///   impulses      solve_island(): ContactSolver, then Clearance
///
/// Results depend neither on the order in which bodies were added nor on far bodies: within an
/// island, bodies are taken from west to east.
class CollisionPipeline {
 public:
  CollisionPipeline(const world::Physics& physics, std::vector<Collider>& colliders,
                    std::vector<Mover>& movers, PlanarScene& scene)
      : physics_(physics),
        colliders_(colliders),
        movers_(movers),
        scene_(scene),
        solver_(physics, movers),
        clearance_(physics, colliders, movers, scene, solver_) {}

  /// A body with a mover.
  struct Moving {
    std::uint32_t collider = 0;
    std::uint32_t mover = 0;
    double reach = 0.0;  // m, of its farthest point from its place
  };

  /// Finds the contacts of bodies that may come nearer by `margin` in this step. `moving` lists all
  /// that still exist.
  void find(std::span<const Moving> moving, double margin, base::ThreadPool& pool);
  /// Gives the movers their velocities; the hinges join them.
  void solve(std::span<Hinge* const> hinges, base::ThreadPool& pool);
  /// Forgets the touches so far.
  void forget_touches() { touches_.clear(); }

  /// Of all calls of find() since forget_touches().
  std::span<const Touch> touches() const { return touches_; }
  /// Those of the last find(), with the impulses of solve().
  std::span<const Contact> contacts() const { return contacts_; }
  /// A body that a box presses into others, because nothing stops the box.
  struct Press {
    std::uint32_t body = 0, box = 0;  // colliders
    double depth = 0.0;               // m, at the end of the step
  };
  /// The presses that solve() found, of most islands none.
  std::span<const Press> presses() const { return presses_; }
  /// The colliders of bodies that do not meet, because one holds the other: ascending pairs.
  void leave_out(std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs) {
    joined_ = std::move(pairs);
  }
  /// Takes over what another engine remembers of the last step.
  void take(const CollisionPipeline& other) { cache_ = other.cache_; }

 private:
  /// A contact of the last step, with which the solver begins.
  struct CachedContact {
    Contact::Key key;
    double normal_impulse, friction_impulse, coming, stored;
  };

  /// What one thread finds.
  struct Found {
    std::vector<Contact> contacts;
    std::vector<Touch> touches;
    std::vector<Press> presses;
    // Kept to reuse their memory.
    std::vector<std::uint32_t> near;
    PairingSpace space;
  };
  /// Bodies that act on each other.
  struct Island {
    std::span<const std::uint32_t> bodies;  // movers
    std::span<Contact> contacts;
    std::span<Hinge* const> hinges;
  };

  void find_contacts_of(const Moving& moving, double margin, Found& found) const;
  void meet(std::uint32_t first, std::uint32_t second, double margin, Found& found) const;
  bool may_meet(std::uint32_t first, std::uint32_t second) const;
  bool is_before(const Collider& a, const Collider& b) const;
  bool pushed(std::uint64_t a, std::uint64_t b) const;
  void recall(Contact& contact) const;
  std::uint32_t root(std::uint32_t mover);
  void join(std::uint32_t a, std::uint32_t b);
  void involve(std::uint32_t mover);
  void order(std::span<Hinge* const> hinges);
  void solve_island(const Island& island, Found& found);
  std::optional<Press> find_press(std::span<const Contact> contacts) const;

  const world::Physics& physics_;
  std::vector<Collider>& colliders_;
  std::vector<Mover>& movers_;
  PlanarScene& scene_;
  ContactSolver solver_;
  Clearance clearance_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joined_;  // see leave_out()
  double margin_ = 0.0;                                          // of the last find()
  std::vector<Contact> contacts_;
  std::vector<Touch> touches_;
  std::vector<Press> presses_;
  std::vector<CachedContact> cache_;  // ascending
  std::vector<Found> found_;          // by each thread
  // Kept to reuse their memory.
  std::vector<Island> islands_;
  /// Island, whether a box that nothing stops takes part, ranks, place, feature, number, and index.
  using ContactPlace = std::tuple<std::uint32_t, bool, std::uint32_t, std::uint32_t, double, double,
                                  std::uint64_t, std::uint64_t, std::size_t>;
  std::vector<ContactPlace> in_order_;
  std::vector<Contact> sorted_;
  std::vector<std::uint32_t> parents_;   // of movers; kFixed: not involved
  std::vector<std::uint32_t> ranks_;     // of movers
  std::vector<std::uint32_t> involved_;  // movers
  std::vector<Impact> impacts_;          // of the involved movers, by their ranks
  std::vector<Hinge*> hinges_;
};

}  // namespace elsie::physics

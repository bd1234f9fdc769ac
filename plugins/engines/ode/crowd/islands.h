// Islands: groups of robots and boxes that are linked by contacts, and the solver of each.
//
// A step of the engine goes through this folder from top to bottom:
//
//   islands.h         contacts divide the bodies into islands, and each island gets a solver: ODE's
//                     own for small ones, else a Crowd
//   crowd.h           writes the bodies, contacts, motors and joints of an island as rows, has them
//                     solved, and moves the bodies
//   composite.h       the mass of a vehicle, which is one rigid body there
//   impulse_solver.h  what a row is; sweeps over all rows, for heaps
//   newton_solver.h   Newton's method for the same rows, for long trains
#pragma once

#include <cstddef>
#include <deque>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "elsie/base/thread_pool.h"
#include "elsie/world/description.h"

#include "contact_finder.h"
#include "crowd.h"
#include "ode_handles.h"
#include "ode_robot.h"

namespace elsie::physics {

/// Sets of members that links have joined (union-find, with path halving: Tarjan and van Leeuwen,
/// 1984).
class DisjointSets {
 public:
  /// Starts with so many members, none linked. Each counts 1, unless count() says otherwise.
  void reset(std::size_t members) {
    parents_.resize(members);
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
    sizes_.assign(members, 1);
  }
  void count(std::size_t member, std::size_t as) { sizes_[member] = as; }
  void link(std::size_t a, std::size_t b) {
    a = first(a);
    b = first(b);
    if (a == b) return;
    if (b < a) std::swap(a, b);
    parents_[b] = a;
    sizes_[a] += sizes_[b];
  }
  /// The first member of this member's set.
  std::size_t first(std::size_t member) {
    while (parents_[member] != member) {
      parents_[member] = parents_[parents_[member]];
      member = parents_[member];
    }
    return member;
  }
  /// The sum of the counts of all members of its set.
  std::size_t size(std::size_t member) { return sizes_[first(member)]; }

 private:
  std::vector<std::size_t> parents_;
  std::vector<std::size_t> sizes_;
};

/// Divides movable robots and boxes by the contacts of a step: small islands are left to ODE, the
/// others are taken out of its step. Where the segments of a few trains that are too long for ODE
/// make up most of an island, it becomes a train of its own; all others become the crowd.
class Islands {
 public:
  enum class OdeTakes { small_islands, nothing };

  Islands(dWorldID world, const world::Physics& physics);

  /// Robots are numbered in the order in which they are added.
  void add_robot(const OdeRobot& robot);
  /// A box that can be pushed, or one that moves along a path of its own.
  void add_obstacle(dBodyID box);
  /// Leaves out a box, until it is added again. Must be called before the body is destroyed.
  void remove_obstacle(dBodyID box);

  /// Makes joints of the contacts within islands that ODE takes. Disables other bodies in ODE, and
  /// adds them to a train or the crowd with their contacts. `bodies` are all that were added.
  void divide(std::span<FoundContacts> found, const OdeBodies& bodies, OdeTakes takes);
  /// Undoes divide(): removes its joints, and enables bodies in ODE. Later contacts are `softer`
  /// times as soft.
  void dissolve(double softer = 1.0);
  /// Moves the bodies that the last divide() disabled by a step, several trains at once.
  void step_others(base::ThreadPool& pool);

 private:
  struct Member {
    std::optional<std::size_t> robot;  // its number; none for a box
    std::size_t segments = 0;
    std::size_t size = 1;         // its count in the sets
    std::vector<dBodyID> bodies;  // none: a removed box
    Crowd* crowd = nullptr;       // that moves it in this step; null: ODE does
  };

  /// Those that are too long for ODE.
  struct Trains {
    std::size_t count = 0;
    std::size_t segments = 0;
  };

  void add(Member member);
  void finish(FoundContact& contact, std::size_t number) const;
  void choose_solvers(OdeTakes takes);
  Crowd& next_train();
  void take_out(Member& member, std::span<const OdeRobot> robots);

  std::vector<Member> members_;  // the data of an ODE body is the place of its member, from 1
  std::size_t robots_ = 0;
  DisjointSets sets_;
  std::vector<Trains> trains_in_;  // in the island with this first member
  dWorldID world_;
  OdeJointGroup joints_;  // of contacts
  double cfm_;
  double softer_ = 1.0;
  world::Physics physics_;
  Crowd crowd_;
  std::deque<Crowd> trains_;  // each an island
  std::size_t used_trains_ = 0;
};

}  // namespace elsie::physics

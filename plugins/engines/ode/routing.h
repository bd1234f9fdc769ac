// Decides which bodies ODE moves in a step, and which others move.
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "elsie/base/thread_pool.h"
#include "elsie/world/description.h"

#include "contact_finder.h"
#include "contact_joints.h"
#include "crowd.h"
#include "islands.h"
#include "ode_robot.h"

namespace elsie::physics {

/// Divides movable robots and boxes by the contacts of a step: small islands are left to ODE, the
/// others are taken out of its step. Where the segments of a few trains that are too long for ODE
/// make up most of an island, it becomes a train of its own; all others become the crowd.
class Routing {
 public:
  enum class OdeTakes { small_islands, nothing };

  explicit Routing(const world::Physics& physics) : physics_(physics), crowd_(physics) {}

  /// Robots are numbered in the order in which they are added.
  void add_robot(const OdeRobot& robot);
  /// A box that can be pushed, or one that moves along a path of its own.
  void add_box(dBodyID box);
  /// Must be called before the body is destroyed.
  void remove_box(dBodyID box);

  /// Makes joints of the contacts within islands that ODE takes. Disables other bodies in ODE, and
  /// adds them to a train or the crowd with their contacts. `robots` are all that were added.
  void divide(std::span<FoundContacts> found, ContactJoints& joints,
              std::span<const OdeRobot> robots, OdeTakes takes);
  /// Enables in ODE the bodies that divide() disabled.
  void wake();
  /// Moves the bodies that the last divide() disabled by a step, several trains at once.
  void step_others(base::ThreadPool& pool);

 private:
  struct Member {
    std::optional<std::size_t> robot;  // its number; none for a box
    std::size_t segments = 0;
    std::size_t size = 1;         // its count for the islands
    std::vector<dBodyID> bodies;  // none: a removed box
    Crowd* mover = nullptr;       // in this step; null: ODE
  };

  /// Those that are too long for ODE.
  struct Trains {
    std::size_t count = 0;
    std::size_t segments = 0;
  };

  void add(Member member);
  void choose_movers(OdeTakes takes);
  Crowd& next_train();
  void take_out(Member& member, std::span<const OdeRobot> robots);

  std::vector<Member> members_;  // the data of an ODE body is the place of its member, from 1
  std::size_t robots_ = 0;
  Islands islands_;
  std::vector<Trains> trains_in_;  // in the island with this first member
  world::Physics physics_;
  Crowd crowd_;
  std::deque<Crowd> trains_;  // each an island
  std::size_t used_trains_ = 0;
};

}  // namespace elsie::physics

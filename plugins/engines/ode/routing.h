// Who is moved by ODE in a step, and who by the crowd's solver.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "elsie/world/description.h"

#include "crowd.h"
#include "islands.h"
#include "ode_contacts.h"
#include "ode_robot.h"

namespace elsie::physics {

/// Divides the robots and boxes that can be moved by the contacts of a step: islands that are small
/// enough are left to ODE, the others are taken out of its step and given to the crowd.
class Routing {
 public:
  enum class OdeTakes { small_islands, nothing };

  explicit Routing(const world::Physics& physics) : crowd_(physics) {}

  /// Robots are numbered in the order in which they are added.
  void add_robot(const OdeRobot& robot);
  /// A box that can be pushed, or one that moves along a path of its own.
  void add_box(dBodyID box);
  /// Before the body is destroyed.
  void remove_box(dBodyID box);

  /// Makes joints of the contacts within islands that ODE takes; what is in others is disabled in
  /// ODE, and added to the crowd with its contacts. `robots` are all that were added.
  void divide(OdeContacts& contacts, std::span<const OdeRobot> robots, OdeTakes takes);
  /// Enables in ODE what divide() disabled.
  void wake();
  /// Moves by a step what the last divide() gave to the crowd.
  void step_crowd() { crowd_.step(); }

 private:
  struct Member {
    std::optional<std::size_t> robot;  // its number; none: a box
    std::size_t size = 1;              // as islands count it
    std::vector<dBodyID> bodies;       // none: a box that is gone
    bool in_crowd = false;             // in this step
  };

  void add(Member member);
  void take_out(Member& member, std::span<const OdeRobot> robots);

  std::vector<Member> members_;  // a body of ODE has as its data the place of its member, from 1
  std::size_t robots_ = 0;
  Islands islands_;
  Crowd crowd_;
};

}  // namespace elsie::physics

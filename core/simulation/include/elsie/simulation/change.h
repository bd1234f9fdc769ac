// Changing a world while it runs.
//
// What a user may change between two steps is an attribute of the world file, by the path that
// leads to it there (world::ReadOptions::overrides) and as text:
//
//   robot[r1]/@x, @y, @z, @heading_deg       puts the robot there, at rest, what it pulls in line
//                                            behind it
//   robot[r1]/@max_speed, @coverage, @leader
//   robot[r1]/@energy                        what is in the battery now
//   robot[r1]/sensor[left]/@energy_cost
//   robot[r1]/behavior[roam]/@priority
//   parameters of sensors, behaviours and coordinators, at any depth, and of the elements in them:
//                                            robot[r1]/sensor[left]/@error
//                                            robot[*]/behavior[roam]/@speed
//                                            robot[r1]/coordinator/suppress[1]/@hold
//
// All else is settled when the world is made, and a change of it is refused with a sentence that
// says so: the arena, physics, boxes, chargers and goals, a robot's body, battery and team, where a
// sensor is mounted, and those parameters whose declaration says that they are not live
// (ParameterFacts::live: what a neural network is trained with).
//
// A change is made as a whole or not at all: the world is as it was when it is refused. What a
// plugin remembers of the run stays; its random stream goes on. A change is forgotten by reset():
// the world is then as its file says, and a run with the same seed and the same changes before the
// same steps is the same, bit for bit.
#pragma once

#include <stdexcept>
#include <string>

namespace elsie::simulation {

/// An attribute and the text that it is to have.
struct Change {
  std::string path;   // "robot[r1]/@max_speed"
  std::string value;  // "0.3"
};

/// A change for later.
struct TimedChange {
  double time_s = 0.0;  // before the first step that begins at this time or after it
  Change change;
};

/// A change that cannot be made. what() is a sentence that starts with the change:
/// "robot[r1]/@max_speed=fast: expected a number at least 0 and at most 100 m/s".
class ChangeRefused : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;

  /// The same about a change for a certain time: "at 3 s, robot[r1]/@max_speed=fast: ...".
  ChangeRefused at(double time_s) const;
};

}  // namespace elsie::simulation

// Changing a world while it runs.
//
// What a user may change between two steps is an attribute of the world file, by the path that
// leads to it there (world::ReadOptions::overrides) and as text. An attribute may change if the
// vocabulary names what changes it (world::LiveRobot), a plugin's parameter if its declaration does
// not forbid it (ParameterFacts::live); all else is settled when the world is made. docs/running.md
// lists what may change.
//
// A change is made as a whole or not at all. What a plugin remembers of the run stays, and its
// random stream goes on. reset() forgets changes: a run with the same seed and the same changes
// before the same steps is the same, bit for bit.
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

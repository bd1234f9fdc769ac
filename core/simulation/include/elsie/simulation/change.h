// Changing a world while it runs.
//
// A user may make any edit of the world between two steps: what world::ReadOptions::overrides says
// of a file, by the same paths and texts, except for its `format`.
//
// An attribute that the vocabulary has something to change for (world::LiveRobot), and a plugin's
// parameter whose declaration does not forbid it (ParameterFacts::live), is put in place: what the
// plugin remembers stays, and its random stream goes on. All else is read and checked as a file is,
// and the simulation becomes the world that comes out: what an edit concerns is made anew, from a
// plugin object to the physics engine, and all the rest keeps its state. docs/running.md says what
// an edit costs.
//
// Edits are made as a whole or not at all. reset() forgets them: a run with the same seed and the
// same edits before the same steps is the same, bit for bit.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace elsie::simulation {

/// An attribute and the text that it is to have, or an element and its markup.
struct Change {
  std::string path;   // "robot[r1]/@max_speed", "robot[r1]/coordinator"
  std::string value;  // "0.3", "<arbiter_suppression/>"

  std::string text() const { return path + "=" + value; }
};

/// A change for later.
struct TimedChange {
  double time_s = 0.0;  // before the first step that begins at this time or after it
  Change change;
  std::string from{};  // "maze.xml:12", where it stands; "": the user gave it
};

/// A change that cannot be made. what() is a sentence that starts with the change:
/// "robot[r1]/@max_speed=fast: expected a number at least 0 and at most 100 m/s".
class ChangeRefused : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;

  /// The same about a change for a certain time: "at 3 s, robot[r1]/@max_speed=fast: ...".
  ChangeRefused at(double time_s, std::string from = "") const;
  /// TimedChange::from.
  const std::string& from() const { return from_; }
  /// Further changes of the same schedule that cannot be made either.
  const std::vector<ChangeRefused>& others() const { return others_; }

  /// A line for each of them: where it stands, or "--at", and the sentence.
  std::string report() const;

  /// Throws the first with all others in it; does nothing if there are none.
  static void raise(std::vector<ChangeRefused> refused);

 private:
  std::string from_;
  std::vector<ChangeRefused> others_;
};

/// Changes of a world that its run ends before.
struct UnmadeChanges {
  std::string from;      // TimedChange::from of the first
  std::string sentence;  // that says so
};

}  // namespace elsie::simulation

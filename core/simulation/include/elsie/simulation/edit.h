// Changing a world during a run.
//
// A user may make any edit of the world between two steps, with the same paths and texts as
// world::ReadOptions::edits, except for `format`.
//
// Some edits are made in place: attributes that the vocabulary marks as live, and parameters of
// plugins unless their declaration forbids it (ParameterFacts::live). The plugin then keeps what it
// remembers, and its random stream continues. For all other edits, the new world is read and
// checked like a file, and the simulation becomes that world: it recreates what the edit affects,
// from a plugin object to the physics engine; the rest keeps its state. docs/changing-a-world.md
// gives the cost of edits.
//
// All edits of one call are made, or none. reset() forgets them. A run with the same seed and the
// same edits before the same steps is the same, bit for bit.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace elsie::simulation {

/// An attribute and its new text, or an element and its new markup.
struct Edit {
  std::string path;   // "robot[r1]/@max_speed", "robot[r1]/coordinator"
  std::string value;  // "0.3", "<arbiter_suppression/>"

  std::string text() const { return path + "=" + value; }
};

/// An edit at a given time.
struct TimedEdit {
  double time_s = 0.0;  // made before the first step that begins at or after this time
  Edit edit;
  std::string from{};  // where it stands, "maze.xml:12"; "": the user gave it
};

/// An edit that cannot be made. what() is a sentence that starts with the edit:
/// "robot[r1]/@max_speed=fast: expected a number at least 0 and at most 100 m/s".
class EditRefused : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;

  /// The same error for an edit at a given time: "at 3 s, robot[r1]/@max_speed=fast: ...".
  EditRefused at(double time_s, std::string from = "") const;
  /// Where the edit stands, as TimedEdit::from.
  const std::string& from() const { return from_; }
  /// The other edits of the same schedule that cannot be made.
  const std::vector<EditRefused>& others() const { return others_; }

  /// One line for each edit: where it stands, or "--at", and the sentence.
  std::string report() const;

  /// Throws the first, which then contains the others; does nothing if there are none.
  static void raise(std::vector<EditRefused> refused);

 private:
  std::string from_;
  std::vector<EditRefused> others_;
};

/// Edits in a world that are not made because the run ends earlier.
struct UnmadeEdits {
  std::string from;      // TimedEdit::from of the first
  std::string sentence;  // for the user
};

}  // namespace elsie::simulation

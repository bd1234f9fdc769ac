// Replacing plugins while a world runs.
//
// Between two steps every object of a plugin whose library has changed makes room for an object of
// the new library, on all robots and at any depth: sensors, behaviours, coordinators. What a new
// object is given:
//
// - its parameters, as the world sets them and as they were changed since; a parameter that the new
//   declaration does not have any more is left out, one that is new has its default;
// - configured(), equipped(), and reset() with its random stream as at the start of the run, as if
//   it had been there from the beginning;
// - what the old one remembers, if both classes derive from Remembers (elsie/api/remember.h);
// - its random stream at the place where the old one left it.
//
// Measures are not replaced: what a new one would tell of the run so far, nobody could say.
//
// The readings of a new sensor are empty until its next update. Priorities, traces, events and the
// bodies of the robots stay as they are.
//
// All objects are replaced or none. Refused is a plugin that is gone, holds behaviours where it did
// not or no longer does, makes readings of another kind, begins or ceases to look through a camera,
// needs a parameter that the world does not give or readings that the robot does not have; or that
// throws. The old objects were not touched then.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace elsie::simulation {

/// What came of it.
struct Replacement {
  struct Object {
    std::string robot;
    std::string path;    // "behavior[explore]/behavior[roam]"
    std::string plugin;  // its name
    bool remembers = false;
  };
  std::vector<Object> objects;     // that are new, in the order of the world
  std::vector<std::string> notes;  // sentences: which parameters were left out
};

/// what() is a sentence for each reason, starting with the robot and the object.
class ReplacementRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace elsie::simulation

// Replacing plugins while a world runs.
//
// Between two steps every object of a plugin whose library has changed makes room for an object of
// the new library, on all robots and at any depth: sensors, behaviours, coordinators; measures
// stay. A new object gets the parameters of the old one, as far as its declaration has them;
// configured(), equipped(), and reset() with its random stream as at the start of the run; what the
// old one remembers, if both classes derive from Remembers (elsie/api/remember.h); and the random
// stream where the old one left it. docs/hot-reload.md says when new objects are refused.
//
// All objects are replaced or none.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace elsie::simulation {

/// The result of a replacement.
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

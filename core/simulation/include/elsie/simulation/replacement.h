// Replacing plugins during a run.
//
// Between two steps, new objects replace all objects of plugins whose library has changed, on all
// robots and at any depth: sensors, behaviours, coordinators; measures stay. A new object gets the
// parameters of the old one that its declaration has; then configured(), equipped(), and reset()
// with its random stream at the start are called. It gets the memory of the old object if both
// classes derive from Remembers (elsie/api/remember.h), and then the present state of the random
// stream. docs/hot-reload.md says when new objects are refused.
//
// Either all objects are replaced or none.
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
  std::vector<Object> objects;     // the new objects, in the order of the world
  std::vector<std::string> notes;  // sentences: which parameters were left out
};

/// what() is a sentence for each reason, starting with the robot and the object.
class ReplacementRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace elsie::simulation

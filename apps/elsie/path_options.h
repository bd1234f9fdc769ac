// Which parts of the robots' ways a picture of a run has.
#pragma once

#include <string>
#include <vector>

#include "elsie/picture/top_view.h"

namespace CLI {
class App;
}

namespace elsie::program {

class PathOptions {
 public:
  /// Adds the options, which need `--picture`.
  void add_to(CLI::App& command);
  /// Throws BadInput for a window of time that is empty, and for a robot that is not in the world.
  void check(const world::World& world) const;

  const picture::PathChoice& choice() const { return choice_; }

 private:
  picture::PathChoice choice_;
};

}  // namespace elsie::program

// Which parts of the robots' ways a picture of a run has.
#pragma once

#include <string>
#include <vector>

#include "elsie/picture/top_view.h"

namespace CLI {
class App;
}

class PathOptions {
 public:
  /// Adds the options, which need `--picture`.
  void add_to(CLI::App& command);
  /// Throws BadInput for a window of time that is empty, and for a robot that is not in the world.
  void check(const elsie::world::World& world) const;

  const elsie::picture::PathChoice& choice() const { return choice_; }

 private:
  elsie::picture::PathChoice choice_;
};

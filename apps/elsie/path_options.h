// Options that select parts of the robots' paths in a picture.
#pragma once

#include <string>
#include <vector>

#include "elsie/picture/top_view.h"

namespace CLI {
class App;
}

namespace elsie::program {

/// Throws BadInput, which begins with the option, for an id that no robot of the world has.
void require_robots(const world::World& world, const std::vector<std::string>& robots,
                    const std::string& option);

class PathOptions {
 public:
  /// Adds the options, which need `--picture`.
  void add_to(CLI::App& command);
  /// Throws BadInput for an empty interval of time, and for an unknown robot.
  void check(const world::World& world) const;

  const picture::PathChoice& choice() const { return choice_; }

 private:
  picture::PathChoice choice_;
};

}  // namespace elsie::program

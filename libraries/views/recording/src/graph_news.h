// What a recording has of the graphs of a robot's coordinators.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "elsie/simulation/simulation.h"

#include "format.h"

namespace elsie::recording {

/// Finds what differs from what was recorded before.
class GraphNews {
 public:
  struct Messages {
    std::optional<Json> graphs, lights;
  };

  /// True if the robot's coordinators had graphs when they were last looked at.
  bool has_graphs() const { return !last_.empty(); }
  /// The messages about the present graphs: the graphs if they are new, and what is lit if that or
  /// they are.
  Messages take(std::vector<simulation::LitGraph> now, std::uint64_t time_ns);

 private:
  std::vector<simulation::LitGraph> last_;  // the names of their plugins may be gone
};

}  // namespace elsie::recording

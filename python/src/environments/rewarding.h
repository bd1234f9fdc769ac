// The rewards of the robots of an environment.
//
// A measure that publishes a number named "reward" rewards the robots that its parameters `robot`
// and `team` name (elsie/learning/reward_learner.h); any value that a run reports rewards all of
// them by how much it grows.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/simulation/simulation.h"

#include "declared.h"

namespace elsie::python {

class Rewarding {
 public:
  /// `robots`: indices. Throws base::BadInput with a sentence for a name that the world does not
  /// have.
  Rewarding(const simulation::Simulation& simulation, const plugin::Host& host,
            const std::vector<std::size_t>& robots,
            const std::optional<std::vector<RewardTerm>>& terms);

  /// Adds the rewards of a control period that has just ended to those of each robot.
  void add_period(const simulation::Simulation& simulation, double* rewards) const;
  /// Adds what values have grown by since the last call, or since it was made.
  void add_growth(const simulation::Simulation& simulation, double* rewards);

 private:
  struct Published {
    std::size_t number;  // in the order of Simulation::visit_published()
    double weight;
    std::vector<std::size_t> robots;  // their places among those of the environment
  };
  struct Value {
    std::size_t index;  // in Simulation::measures()
    double weight;
    std::optional<double> last;
  };

  std::size_t robots_;
  std::vector<Published> published_;
  std::vector<Value> values_;
};

}  // namespace elsie::python

// Coordinators with their teams.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "shipped.h"
#include "situation.h"

namespace elsie::test {

inline void check_near(const MotorCommand& command, const MotorCommand& expected,
                       double within = 1e-9) {
  CHECK(command.left == Approx(expected.left).margin(within));
  CHECK(command.right == Approx(expected.right).margin(within));
}

/// A team and its coordinator, ready to run.
class Coordinated {
 public:
  Coordinated(const char* coordinator, Team& team, Parameters parameters = {},
              const std::vector<ElementValue>& elements = {})
      : team_(team),
        coordinator_(make<Coordinator>(PluginKind::coordinator, coordinator, std::move(parameters),
                                       elements)) {
    coordinator_->equipped(team.members(), now.perception());
    reset();
  }

  void reset() {
    Random random;
    coordinator_->reset(random);
  }
  MotorCommand decide() {
    team_.next_step();
    return given_ = coordinator_->coordinate(team_.members(), now.perception());
  }
  MotorCommand decide_at(double time_s) {
    now.after(time_s);
    return decide();
  }
  /// What an outer coordinator would hear after a decision.
  std::vector<double> rate(const std::vector<MotorCommand>& candidates) {
    std::vector<double> desirability(candidates.size());
    coordinator_->rate(team_.members(), given_, candidates, desirability);
    return desirability;
  }
  CommandSets sets() { return coordinator_->command_sets(team_.members(), given_); }
  Coordinator& operator*() { return *coordinator_; }

  Situation now;

 private:
  Team& team_;
  plugin::Object<Coordinator> coordinator_;
  MotorCommand given_;
};

}  // namespace elsie::test

// What an environment declares: what its robots observe and act, by names.
//
// The names are those of files, recordings and `--set`; docs/learning.md lists them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace elsie::python {

/// A name, with bounds in place of those that are known.
struct Named {
  std::string name;
  std::optional<double> low{}, high{};
};

/// One number that is observed or acted, with its bounds.
struct Bounded {
  std::string name;
  double low = 0.0, high = 0.0;

  void take_bounds(const Named& named) {
    low = named.low.value_or(low);
    high = named.high.value_or(high);
  }
};

/// A term of the reward: a measure that publishes rewards, or a value that results list.
struct RewardTerm {
  std::string name;
  double weight = 1.0;
};

struct Declared {
  std::vector<std::string> robots;  // ids
  std::vector<Named> observe;
  std::vector<Named> act;
  /// None: all measures that reward the robot.
  std::optional<std::vector<RewardTerm>> rewards;
  std::size_t steps = 0;  // of the physics in one of the environment; 0: a control period
  std::optional<double> time_limit_s;
  /// The numbers of each robot, once they are known: they stay, whatever is edited or drawn.
  std::vector<std::vector<Bounded>> observed{}, acted{};
};

}  // namespace elsie::python

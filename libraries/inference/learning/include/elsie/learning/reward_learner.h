// The interface of coordinators that learn from rewards, for programs.
//
// A world declares its rewards: every measure that publishes a number named "reward"
// (elsie::publishes(), docs/writing-a-measure.md) rewards the robot that its parameter `robot`
// names, all robots of the team that its parameter `team` names, or, with neither, every robot. The
// number is the reward of the present control period, from one decision to the next, and complete
// when the period ends. Whatever trains a robot uses this declaration.
//
//   learner.begin({"food", "harm"}, known, 0.3, Random(seed, "explore"));   // after reset()
//   after each control period: learner.learned(rewards);
//   known = learner.finish(Ending::goal);
#pragma once

#include <span>
#include <string>
#include <vector>

#include "elsie/base/random.h"
#include "elsie/learning/values.h"

namespace elsie::learning {

/// The name of the number that makes a measure a reward.
inline constexpr const char* kReward = "reward";

/// How an episode ended.
enum class Ending {
  goal,     // reached or missed for good: nothing follows
  cut_off,  // by a limit of time: what would have followed has a value
};

/// Coordinator plugins that learn from rewards also derive from this class. Programs find them by
/// dynamic_cast, because neither the core nor the program knows a plugin by name:
///
///   if (auto* learner = dynamic_cast<learning::RewardLearner*>(&object)) ...
///
/// All of them have these parameters, with the same meanings: `values`, the file of what was
/// learned, and `untrained`, which lets a robot without that file run. Outside of begin() and
/// finish() they learn nothing: a run with a file of values does not change them.
class RewardLearner {
 public:
  virtual ~RewardLearner();

  /// An episode begins, in which it learns. To be called after reset(), before the first decision.
  /// `rewards`: names of the rewards, of the measures' ids, in the order of the world; `known`:
  /// what finish() returned last, or nothing; `exploration`: the probability, in [0, 1], that a
  /// decision is drawn from `random`, not made. Throws std::invalid_argument with a sentence when
  /// it cannot learn from these rewards.
  virtual void begin(const std::vector<std::string>& rewards, Values known, double exploration,
                     const Random& random) = 0;

  /// The rewards of a control period that has just ended, in the order of begin(). Throws
  /// std::logic_error without begin(): the object is not the one that began the episode.
  virtual void learned(std::span<const double> rewards) = 0;

  /// The episode is over. Returns all that it has learned so far, also when nothing happened since
  /// begin(): at least one table, all with the same states, and remarks that can be written.
  virtual Values finish(Ending ending) = 0;
};

}  // namespace elsie::learning

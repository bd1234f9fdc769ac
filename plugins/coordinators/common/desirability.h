// The desirability of commands to several behaviours together.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include <elsie/api/coordinator.h>

#include "command_space.h"

/// The mean of the members' ratings, weighted with the weights in their traces. Members without a
/// weight are not asked. Does not allocate once its memory has grown to the largest number of
/// candidates.
class Desirability {
 public:
  /// The space of commands, and its largest effective coordinate, rad/s. A faster command is scaled
  /// down as a whole, so a command at the limit stands for all faster ones in its direction: a
  /// behaviour that wishes for more rates it like the one of these nearest to its wish. Infinite by
  /// default: ratings may be passed outwards, and then the outermost coordinator scales commands.
  void set_limit(const CommandSpace& space, double limit) {
    space_ = space;
    limit_ = limit;
  }

  /// Writes the mean for each candidate, in [0, 1]; zero without any weight.
  void rate(std::span<elsie::Member> members, std::span<const elsie::Motion> candidates,
            std::span<double> mean);

  /// Writes each member's share in the desirability of `command` to its trace.
  void trace_shares(std::span<elsie::Member> members, const elsie::Motion& command);

  /// The mean of the members' fuzzy sets, with the same weights.
  static elsie::CommandSets sets(std::span<elsie::Member> members);

 private:
  void rate_one(elsie::Member& member, std::span<const elsie::Motion> candidates,
                std::span<double> ratings);

  CommandSpace space_;
  double limit_ = std::numeric_limits<double>::infinity();
  std::vector<double> ratings_;           // of one member
  std::vector<elsie::Motion> stretched_;  // candidates, scaled up to a member's wish
};

/// Values closer than this, relatively, count as equal: far above rounding, far below relevant
/// differences.
inline constexpr double kEqual = 1e-9;

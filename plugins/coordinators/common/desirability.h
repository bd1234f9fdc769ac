// The desirability of commands to several behaviours together.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <elsie/api/coordinator.h>

/// The mean of the members' ratings, weighted with the weights in their traces. Members without a
/// weight are not asked. Does not allocate once its memory has grown to the largest number of
/// candidates.
class Desirability {
 public:
  /// The largest effective wheel rate, rad/s. A faster command is scaled down for both wheels, so
  /// that a command at the limit stands for all those beyond it on its ray: a behaviour that wishes
  /// for more rates it like the one of these nearest to its wish. Infinite by default: for ratings
  /// that are passed outwards, the outermost coordinator scales commands.
  void set_limit(double limit) { limit_ = limit; }

  /// Writes the mean for each candidate, in [0, 1]; zero without any weight.
  void rate(std::span<elsie::Member> members, std::span<const elsie::MotorCommand> candidates,
            std::span<double> mean);

  /// Writes each member's share in the desirability of `command` to its trace.
  void trace_shares(std::span<elsie::Member> members, const elsie::MotorCommand& command);

  /// The mean of the members' fuzzy sets, with the same weights.
  static elsie::CommandSets sets(std::span<elsie::Member> members);

 private:
  void rate_one(elsie::Member& member, std::span<const elsie::MotorCommand> candidates,
                std::span<double> ratings);

  double limit_ = std::numeric_limits<double>::infinity();
  std::vector<double> ratings_;                 // of one member
  std::vector<elsie::MotorCommand> stretched_;  // candidates, scaled up to a member's wish
};

/// Values closer than this, relatively, count as equal: far above rounding, far below relevant
/// differences.
inline constexpr double kEqual = 1e-9;

/// The larger wheel rate without its sign.
inline double fastest_wheel(const elsie::MotorCommand& command) {
  return std::max(std::abs(command.left), std::abs(command.right));
}

/// The square of the distance of two commands in the plane of wheel rates, (rad/s)^2.
inline double distance_squared(const elsie::MotorCommand& a, const elsie::MotorCommand& b) {
  const double left = a.left - b.left;
  const double right = a.right - b.right;
  return left * left + right * right;
}

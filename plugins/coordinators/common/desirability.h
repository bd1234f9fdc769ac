// How good commands are to several behaviours together.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <elsie/api/coordinator.h>

/// The mean of the members' ratings, weighted with the weights in their traces. Members without a
/// weight are not asked. Memory is kept: once it has grown to the largest number of candidates,
/// nothing is allocated.
class Desirability {
 public:
  /// The largest wheel rate that makes a difference, rad/s. A command beyond it is cut down by one
  /// factor for both wheels, so that at the limit one command stands for all those on the ray from
  /// it outwards: to a behaviour that wishes for more it is as good as the one of these that is
  /// nearest to its wish. Infinite by default: for the ratings that go outwards, which the
  /// outermost coordinator cuts down.
  void set_limit(double limit) { limit_ = limit; }

  /// Writes the mean for each candidate, in [0, 1]; zero where there is no weight at all.
  void rate(std::span<elsie::Member> members, std::span<const elsie::MotorCommand> candidates,
            std::span<double> mean);

  /// Notes in the traces how much of the desirability of `command` comes from each member: its
  /// share.
  void trace_shares(std::span<elsie::Member> members, const elsie::MotorCommand& command);

  /// The mean of the members' fuzzy sets, weighted likewise.
  static elsie::CommandSets sets(std::span<elsie::Member> members);

 private:
  void rate_one(elsie::Member& member, std::span<const elsie::MotorCommand> candidates,
                std::span<double> ratings);

  double limit_ = std::numeric_limits<double>::infinity();
  std::vector<double> ratings_;                 // of one member
  std::vector<elsie::MotorCommand> stretched_;  // candidates, as far out as one member wishes
};

/// Two commands are equally good when they differ by no more than this part: far above rounding,
/// and far below what anyone could mean.
inline constexpr double kEqual = 1e-9;

/// The larger of the wheels' rates, without sign.
inline double fastest_wheel(const elsie::MotorCommand& command) {
  return std::max(std::abs(command.left), std::abs(command.right));
}

/// The square of the distance of two commands in the plane of wheel rates, (rad/s)^2.
inline double distance_squared(const elsie::MotorCommand& a, const elsie::MotorCommand& b) {
  const double left = a.left - b.left;
  const double right = a.right - b.right;
  return left * left + right * right;
}

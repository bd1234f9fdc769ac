// What stands in for wishes that a plugin does not spell out: a bump around its command.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "elsie/api/motor_command.h"
#include "elsie/base/fuzzy_set.h"

namespace elsie {

inline constexpr double kBumpWidth = 5.0;  // rad/s

inline void rate_by_distance(const MotorCommand& command, std::span<const MotorCommand> candidates,
                             std::span<double> desirability) {
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const double left = (candidates[i].left - command.left) / kBumpWidth;
    const double right = (candidates[i].right - command.right) / kBumpWidth;
    desirability[i] = std::exp(-0.5 * (left * left + right * right));
  }
}

inline CommandSets triangles_around(const MotorCommand& command) {
  return {FuzzySet::triangle(command.left, kBumpWidth),
          FuzzySet::triangle(command.right, kBumpWidth)};
}

}  // namespace elsie

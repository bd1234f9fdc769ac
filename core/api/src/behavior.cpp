#include "elsie/api/behavior.h"

#include <cmath>
#include <cstddef>

namespace elsie {
namespace {
constexpr double kBumpWidth = 5.0;  // rad/s
}

void Behavior::equipped(const Perception&) {}

void Behavior::rate(const Response& given, std::span<const MotorCommand> candidates,
                    std::span<double> desirability) const {
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const double left = (candidates[i].left - given.command.left) / kBumpWidth;
    const double right = (candidates[i].right - given.command.right) / kBumpWidth;
    desirability[i] = std::exp(-0.5 * (left * left + right * right));
  }
}

CommandSets Behavior::command_sets(const Response& given) const {
  return {FuzzySet::triangle(given.command.left, kBumpWidth),
          FuzzySet::triangle(given.command.right, kBumpWidth)};
}

}  // namespace elsie

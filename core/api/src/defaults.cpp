// What a behaviour or a coordinator answers that does not say anything else: a bump around its
// command.
#include <cmath>

#include "elsie/api/behavior.h"
#include "elsie/api/coordinator.h"

namespace elsie {
namespace {

constexpr double kBumpWidth = 5.0;  // rad/s

void rate_by_distance(const MotorCommand& command, std::span<const MotorCommand> candidates,
                      std::span<double> desirability) {
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const double left = (candidates[i].left - command.left) / kBumpWidth;
    const double right = (candidates[i].right - command.right) / kBumpWidth;
    desirability[i] = std::exp(-0.5 * (left * left + right * right));
  }
}

CommandSets triangles_around(const MotorCommand& command) {
  return {FuzzySet::triangle(command.left, kBumpWidth),
          FuzzySet::triangle(command.right, kBumpWidth)};
}

}  // namespace

void Behavior::equipped(const Perception&) {}

void Behavior::rate(const Response& given, std::span<const MotorCommand> candidates,
                    std::span<double> desirability) const {
  rate_by_distance(given.command, candidates, desirability);
}

CommandSets Behavior::command_sets(const Response& given) const {
  return triangles_around(given.command);
}

void Coordinator::equipped(std::span<const Member>, const Perception&) {}

void Coordinator::rate(std::span<Member>, const MotorCommand& given,
                       std::span<const MotorCommand> candidates, std::span<double> desirability) {
  rate_by_distance(given, candidates, desirability);
}

CommandSets Coordinator::command_sets(std::span<Member>, const MotorCommand& given) {
  return triangles_around(given);
}

}  // namespace elsie

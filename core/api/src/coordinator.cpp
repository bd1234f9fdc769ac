#include "elsie/api/coordinator.h"

#include "bump.h"

namespace elsie {

void Coordinator::equipped(std::span<const Member>, const Perception&) {}

void Coordinator::rate(std::span<Member>, const MotorCommand& given,
                       std::span<const MotorCommand> candidates, std::span<double> desirability) {
  rate_by_distance(given, candidates, desirability);
}

CommandSets Coordinator::command_sets(std::span<Member>, const MotorCommand& given) {
  return triangles_around(given);
}

}  // namespace elsie

#include "elsie/api/behavior.h"

#include "bump.h"

namespace elsie {

void Behavior::equipped(const Perception&) {}

void Behavior::rate(const Response& given, std::span<const MotorCommand> candidates,
                    std::span<double> desirability) const {
  rate_by_distance(given.command, candidates, desirability);
}

CommandSets Behavior::command_sets(const Response& given) const {
  return triangles_around(given.command);
}

}  // namespace elsie

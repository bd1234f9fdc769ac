// The default answers of behaviours and coordinators: a bump around the command.
#include <algorithm>
#include <cmath>

#include "elsie/api/behavior.h"
#include "elsie/api/coordinator.h"

namespace elsie {
namespace {

constexpr double kBumpWidth = 5.0;  // rad/s

void rate_by_distance(const OwnState& self, Motion command, std::span<const Motion> candidates,
                      std::span<double> desirability) {
  if (!self.channels.lateral) {
    command.lateral = 0.0;  // candidates have no lateral speed either
  }
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    desirability[i] = std::exp(-0.5 * self.wheels.distance_squared(candidates[i], command) /
                               (kBumpWidth * kBumpWidth));
  }
}

CommandSets triangles_around(const OwnState& self, const Motion& command) {
  const WheelRates rates = self.wheels.wheel_rates(command);
  CommandSets sets{FuzzySet::triangle(rates.left, kBumpWidth),
                   FuzzySet::triangle(rates.right, kBumpWidth)};
  if (self.channels.lateral) {
    sets.lateral = FuzzySet::triangle(command.lateral, kBumpWidth * self.wheels.radius);
  }
  return sets;
}

}  // namespace

void Behavior::equipped(const Perception&) {}

void Behavior::rate(const Perception& now, const Response& given,
                    std::span<const Motion> candidates, std::span<double> desirability) const {
  rate_by_distance(now.self(), given.command, candidates, desirability);
}

CommandSets Behavior::command_sets(const Perception& now, const Response& given) const {
  return triangles_around(now.self(), given.command);
}

void Coordinator::equipped(std::span<const Member>, const Perception&) {}

std::size_t Coordinator::resolve(std::string_view, std::span<const ActuatorWish> wishes) {
  return greatest_priority(wishes);
}

std::size_t greatest_priority(std::span<const ActuatorWish> wishes) {
  const auto less = [](const ActuatorWish& a, const ActuatorWish& b) {
    return a.member->priority() < b.member->priority();
  };
  return static_cast<std::size_t>(std::max_element(wishes.begin(), wishes.end(), less) -
                                  wishes.begin());
}

void Coordinator::rate(std::span<Member>, const Perception& now, const Motion& given,
                       std::span<const Motion> candidates, std::span<double> desirability) {
  rate_by_distance(now.self(), given, candidates, desirability);
}

CommandSets Coordinator::command_sets(std::span<Member>, const Perception& now,
                                      const Motion& given) {
  return triangles_around(now.self(), given);
}

}  // namespace elsie

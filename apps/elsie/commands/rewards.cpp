#include "rewards.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "elsie/learning/reward_learner.h"

namespace elsie::program {

namespace {

/// The value of a text parameter; "" if it has none of this name.
std::string text_parameter(const world::PluginUse& use, const std::string& name) {
  const auto given = use.parameters.find(name);
  const auto* const text =
      given == use.parameters.end() ? nullptr : std::get_if<std::string>(&given->second);
  return text ? *text : "";
}

bool publishes_reward(const Declaration& measure) {
  return std::any_of(
      measure.published.begin(), measure.published.end(),
      [](const PublishedNumber& number) { return number.name == learning::kReward; });
}

}  // namespace

std::vector<std::string> rewards_of(const world::World& world, std::size_t robot,
                                    const plugin::Host& host) {
  const world::Robot& rewarded = world.robots[robot];
  std::vector<std::string> ids;
  for (const world::PluginUse& use : world.measures) {
    const Declaration* const measure = host.find(PluginKind::measure, use.plugin);
    if (!measure || !publishes_reward(*measure)) continue;
    const std::string one = text_parameter(use, "robot"), team = text_parameter(use, "team");
    if ((one.empty() || one == rewarded.id) && (team.empty() || team == rewarded.team)) {
      ids.push_back(use.id);
    }
  }
  return ids;
}

void read_rewards(const simulation::Simulation& simulation, std::span<const std::string> ids,
                  std::span<double> rewards) {
  std::fill(rewards.begin(), rewards.end(), 0.0);
  simulation.visit_published([&](const simulation::PublishedValue& published) {
    if (published.number.name != learning::kReward || std::isnan(published.value)) return;
    const auto found = std::find(ids.begin(), ids.end(), published.path);
    if (found != ids.end()) {
      rewards[static_cast<std::size_t>(found - ids.begin())] = published.value;
    }
  });
}

}  // namespace elsie::program

#include "rewarding.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "elsie/base/error.h"
#include "elsie/base/near_name.h"
#include "elsie/learning/reward_learner.h"

namespace elsie::python {
namespace {

/// The value of a text parameter; "" if it has none of this name.
std::string text_parameter(const world::PluginUse& use, const char* name) {
  const auto given = use.parameters.find(name);
  const auto* const text =
      given == use.parameters.end() ? nullptr : std::get_if<std::string>(&given->second);
  return text ? *text : "";
}

}  // namespace

Rewarding::Rewarding(const simulation::Simulation& simulation, const plugin::Host& host,
                     const std::vector<std::size_t>& robots,
                     const std::optional<std::vector<RewardTerm>>& terms)
    : robots_(robots.size()) {
  const world::World& world = simulation.world();
  std::vector<std::string> known;
  // Published by measures, then by rules.
  std::size_t number = 0;
  for (const world::PluginUse& use : world.measures) {
    const Declaration* const measure = host.find(PluginKind::measure, use.plugin);
    for (const PublishedNumber& published : measure->published) {
      const std::size_t at = number++;
      if (published.name != learning::kReward) continue;
      known.push_back(use.id);
      double weight = 1.0;
      if (terms) {
        const auto term = std::find_if(terms->begin(), terms->end(),
                                       [&](const auto& each) { return each.name == use.id; });
        if (term == terms->end()) continue;
        weight = term->weight;
      }
      const std::string one = text_parameter(use, "robot"), team = text_parameter(use, "team");
      Published reward{at, weight, {}};
      for (std::size_t i = 0; i < robots.size(); ++i) {
        const world::Robot& robot = world.robots[robots[i]];
        if ((one.empty() || one == robot.id) && (team.empty() || team == robot.team)) {
          reward.robots.push_back(i);
        }
      }
      published_.push_back(std::move(reward));
    }
  }
  if (!terms) return;
  const std::vector<simulation::MeasuredValue> values = simulation.measures();
  for (const RewardTerm& term : *terms) {
    if (std::find(known.begin(), known.end(), term.name) != known.end()) continue;
    const auto value = std::find_if(values.begin(), values.end(),
                                    [&](const auto& each) { return each.name == term.name; });
    if (value == values.end()) {
      for (const simulation::MeasuredValue& each : values) known.push_back(each.name);
      throw base::BadInput("reward: the world has no measure or value that is named '" + term.name +
                           "'" + base::near_or_all(term.name, known, "it has"));
    }
    values_.push_back(
        {static_cast<std::size_t>(value - values.begin()), term.weight, value->value});
  }
}

void Rewarding::add_period(const simulation::Simulation& simulation, double* rewards) const {
  if (published_.empty()) return;
  std::size_t number = 0;
  auto next = published_.begin();
  simulation.visit_published([&](const simulation::PublishedValue& published) {
    if (next == published_.end() || next->number != number++) return;
    const double reward = std::isnan(published.value) ? 0.0 : next->weight * published.value;
    for (const std::size_t robot : next->robots) rewards[robot] += reward;
    ++next;
  });
}

void Rewarding::add_growth(const simulation::Simulation& simulation, double* rewards) {
  if (values_.empty()) return;
  const std::vector<simulation::MeasuredValue> now = simulation.measures();
  for (Value& each : values_) {
    const std::optional<double>& value = now[each.index].value;
    if (!value) continue;
    const double growth = each.weight * (*value - each.last.value_or(0.0));
    each.last = value;
    for (std::size_t i = 0; i < robots_; ++i) rewards[i] += growth;
  }
}

}  // namespace elsie::python

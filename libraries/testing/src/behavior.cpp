#include "elsie/testing/behavior.h"

#include <algorithm>

#include "made.h"

namespace elsie::testing {

Response Inside::respond(const Perception&) {
  ++asked;
  return answer;
}

void Inside::rate(std::span<const Motion> candidates, std::span<double> desirability) {
  std::transform(candidates.begin(), candidates.end(), desirability.begin(),
                 [&](const Motion& candidate) {
                   return candidate == answer.command ? answer.activation : 0.0;
                 });
}

CommandSets Inside::command_sets() {
  const WheelRates rates = WheelPair().wheel_rates(answer.command);
  return {FuzzySet::triangle(rates.left, 5.0), FuzzySet::triangle(rates.right, 5.0)};
}

Behavior::Behavior(const std::string& name, const Settings& settings, const Elements& elements)
    : Behavior(Plugins::found(), name, settings, elements) {}

Behavior::Behavior(const Plugins& plugins, const std::string& name, const Settings& settings,
                   const Elements& elements)
    : plugins_(plugins),
      declaration_(&plugins_.declaration(PluginKind::behavior, name)),
      inside_(std::make_unique<Inside>()),
      random_(1) {
  object_ = make<elsie::Behavior>(plugins_, *declaration_, settings, elements,
                                  [&](elsie::Behavior& object) {
                                    if (declaration_->hold) {
                                      declaration_->hold(object, *inside_);
                                    }
                                  });
}

Response Behavior::respond(const Situation& now) {
  if (!example_) {
    equip(now);
  }
  if (!reset_) {
    reset();
  }
  return object_->respond(now.perception().with_random(random_));
}

std::vector<Response> Behavior::respond(const Sequence& sequence) {
  std::vector<Response> responses;
  for (const Situation& now : sequence.instants()) {
    responses.push_back(respond(now));
  }
  return responses;
}

void Behavior::reset(std::uint64_t seed) {
  seed_ = seed;
  random_ = Random(seed);
  object_->reset(random_);
  reset_ = true;
}

bool Behavior::take_over(Behavior& before) {
  reset(before.seed_);
  random_ = before.random_;
  return hand_over(*before.object_, *object_);
}

void Behavior::equip(const Situation& example) {
  object_->equipped(example.perception());
  example_ = example;
}

void Behavior::set(const Settings& settings) {
  Settings given;  // parameters that are not set here keep their values
  for (const auto& [name, value] : plugins_.completed(*declaration_, settings)) {
    if (settings.contains(name)) {
      given.emplace(name, value);
    }
  }
  plugin::apply_parameters(*declaration_, *object_, given);
  if (example_) {
    object_->equipped(example_->perception());
  }
}

}  // namespace elsie::testing

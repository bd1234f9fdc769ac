#include "changes/tuning.h"

#include <algorithm>
#include <memory>

#include "elsie/plugin/parameters.h"

namespace elsie::simulation {
namespace {

void apply(const TunedObject& tuned, Component& object, const Setup& setup,
           const Perception& example) {
  plugin::apply_parameters(*tuned.declaration, object, setup.parameters, setup.elements);
  Tuning::equip(tuned, object, example);
}

}  // namespace

Setup Tuning::complete(Setup setup, const Setup& now, const Declaration& declaration) {
  for (const ParameterDeclaration& parameter : declaration.parameters) {
    if (now.parameters.contains(parameter.name)) {
      setup.parameters.try_emplace(parameter.name, parameter.default_value);
    }
  }
  return setup;
}

Setup as_described(const world::PluginUse& use) {
  return {use.parameters, {use.elements.begin(), use.elements.end()}};
}

bool Tuning::is_changed(const world::PluginUse& use) const {
  return std::any_of(changed_.begin(), changed_.end(),
                     [&](const auto& changed) { return changed.first == &use; });
}

void Tuning::equip(const TunedObject& tuned, Component& object, const Perception& example) {
  if (tuned.kind == PluginKind::behavior) {
    static_cast<Behavior&>(object).equipped(example);
  } else if (tuned.kind == PluginKind::coordinator) {
    static_cast<Coordinator&>(object).equipped(tuned.members, example);
  } else if (tuned.kind == PluginKind::sensor) {
    static_cast<Sensor&>(object).equipped(tuned.carrier);
  }
}

void Tuning::take_over(const world::PluginUse& use, Setup setup) {
  for (auto& [changed, known] : changed_) {
    if (changed == &use) {
      known = std::move(setup);
      return;
    }
  }
}

Setup Tuning::setup(const world::PluginUse& use) const {
  for (const auto& [changed, setup] : changed_) {
    if (changed == &use) {
      return setup;
    }
  }
  return as_described(use);
}

std::optional<Camera> Tuning::try_out(const TunedObject& tuned, const Setup& setup,
                                      const Perception& example) {
  const std::unique_ptr<Component> object = tuned.declaration->create();
  plugin::hold_nothing(*tuned.declaration, *object);
  apply(tuned, *object, setup, example);
  return tuned.kind == PluginKind::sensor ? static_cast<Sensor&>(*object).camera() : std::nullopt;
}

void Tuning::set(const TunedObject& tuned, Setup setup, const Perception& example) {
  setup = complete(std::move(setup), this->setup(*tuned.use), *tuned.declaration);
  const auto known = std::find_if(changed_.begin(), changed_.end(),
                                  [&](const auto& changed) { return changed.first == tuned.use; });
  // Noted first: what the plugin refuses may have been set in part.
  const Setup& noted = known == changed_.end()
                           ? changed_.emplace_back(tuned.use, std::move(setup)).second
                           : known->second = std::move(setup);
  apply(tuned, *tuned.object, noted, example);
}

std::vector<const world::PluginUse*> Tuning::changed() const {
  std::vector<const world::PluginUse*> uses;
  for (const auto& [use, setup] : changed_) {
    uses.push_back(use);
  }
  return uses;
}

void Tuning::forget(const TunedObject& tuned, const Perception& example) {
  set(tuned, as_described(*tuned.use), example);
  std::erase_if(changed_, [&](const auto& changed) { return changed.first == tuned.use; });
}

}  // namespace elsie::simulation

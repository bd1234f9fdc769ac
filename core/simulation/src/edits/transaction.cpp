#include "edits/transaction.h"

#include <algorithm>
#include <memory>
#include <string>

#include "elsie/plugin/declared_element.h"
#include "elsie/world/same.h"

namespace elsie::simulation {
namespace {

/// Returns whether parameters differ that cannot change during a run.
bool differ_for_good(const std::vector<ParameterDeclaration>& declared,
                     const std::map<std::string, ParameterValue>& a,
                     const std::map<std::string, ParameterValue>& b) {
  const auto value = [](const auto& values, const ParameterDeclaration& of) {
    const auto known = values.find(of.name);
    return known == values.end() ? of.default_value : known->second;
  };
  return std::any_of(declared.begin(), declared.end(), [&](const ParameterDeclaration& one) {
    return !one.facts.live && value(a, one) != value(b, one);
  });
}

bool differ_for_good(const plugin::DeclaredElement& around, const std::vector<world::ElementUse>& a,
                     const std::vector<world::ElementUse>& b) {
  return !std::equal(
      a.begin(), a.end(), b.begin(), b.end(), [&](const auto& one, const auto& other) {
        if (one.element != other.element) return false;
        const auto declared = around.inside(one.element);
        return !differ_for_good(declared->parameters(), one.parameters, other.parameters) &&
               !differ_for_good(*declared, one.elements, other.elements);
      });
}

}  // namespace

bool EditTransaction::keeps(PluginObject& object, const world::PluginUse& was,
                            const world::PluginUse& next) {
  if (!world::same(was, next)) {
    const Declaration& declaration = *object.declaration;
    if (was.plugin != next.plugin || was.id != next.id ||
        differ_for_good(declaration.parameters, was.parameters, next.parameters) ||
        differ_for_good(plugin::DeclaredElement(declaration), was.elements, next.elements)) {
      return false;
    }
    const Setup before = as_described(was), now = as_described(next);
    again_with_[&object] = {object.completed(before, now), object.completed(now, before)};
  }
  describe(object, next);
  return true;
}

void EditTransaction::equip_again(PluginObject& object, const Example& example) {
  const Tuned tuned = has_other(object) ? again_with_.at(&object) : Tuned();
  blaming(*object.use, problems_, [&] {
    if (tuned.now) object.try_out(*tuned.now, example);
    const Memory memory = memory_of(*object.held);
    again_.add([&object, before = tuned.before, memory, example] {
      std::vector<base::Problem> ignored;
      blaming(*object.use, ignored, [&] { object.equip_again(before, memory, example); });
    });
    object.equip_again(tuned.now, memory, example);
  });
}

}  // namespace elsie::simulation

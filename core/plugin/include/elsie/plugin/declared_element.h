// Elements inside a plugin's element, to any depth.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/declaration.h"
#include "elsie/plugin/parameters.h"

namespace elsie::plugin {

/// A plugin's own element, or one that it declares: its parameters, and what may stand in it. The
/// declaration must outlive it.
class DeclaredElement {
 public:
  explicit DeclaredElement(const Declaration& plugin)
      : among_(&plugin.elements), parameters_(&plugin.parameters) {}

  const std::vector<ParameterDeclaration>& parameters() const { return *parameters_; }
  /// Null for the plugin's own.
  const ElementDeclaration* element() const { return element_; }
  /// The element of this name in this one; none if it may not stand here.
  std::optional<DeclaredElement> inside(std::string_view name) const {
    if (element_) {
      if (const auto* own = find_declared(element_->elements, name)) {
        return DeclaredElement(element_->elements, *own);
      }
      if (!element_->nests) return std::nullopt;
    }
    const auto* const found = find_declared(*among_, name);
    if (!found || (element_ && found->list != element_->list)) return std::nullopt;
    return DeclaredElement(*among_, *found);
  }
  /// The names of all that may stand here.
  std::vector<std::string> names_inside() const {
    std::vector<std::string> names;
    if (element_) {
      for (const ElementDeclaration& each : element_->elements) names.push_back(each.name);
    }
    for (const ElementDeclaration& each : *among_) {
      if (!element_ || (element_->nests && each.list == element_->list)) names.push_back(each.name);
    }
    return names;
  }

 private:
  DeclaredElement(const std::vector<ElementDeclaration>& among, const ElementDeclaration& element)
      : among_(&among), element_(&element), parameters_(&element.parameters) {}

  const std::vector<ElementDeclaration>* among_;  // where it is declared
  const ElementDeclaration* element_ = nullptr;
  const std::vector<ParameterDeclaration>* parameters_;
};

/// The element at the end of a way of indices, from a plugin's elements inwards; the way is not
/// empty.
template <class Elements>
auto& element_at(Elements& elements, std::span<const std::size_t> way) {
  auto* at = &elements[way.front()];
  for (const std::size_t i : way.subspan(1)) at = &at->elements[i];
  return *at;
}

}  // namespace elsie::plugin

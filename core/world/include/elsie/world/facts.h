// Properties that many attributes share.
#pragma once

#include <string>
#include <utility>

#include "elsie/shapes/outline.h"
#include "elsie/world/describe.h"

namespace elsie::world {

inline constexpr AttributeExtras kId{.form = TextForm::id};
inline constexpr AttributeExtras kRequiredId{.form = TextForm::id, .required = true};
inline constexpr AttributeExtras kTeam{
    .form = TextForm::id, .refers_to = Reference::team, .cost = Cost::nothing};
inline constexpr AttributeExtras kRobot{.form = TextForm::id, .refers_to = Reference::robot};
inline constexpr AttributeExtras kRequired{.required = true};

/// For an attribute that may change during a run. Simulations know each of these.
inline constexpr AttributeExtras kLive{.cost = Cost::value};
/// For an attribute whose change costs nothing, although a change of its element does.
inline constexpr AttributeExtras kCheap{.cost = Cost::nothing};

inline ParameterFacts fact(std::string meaning) { return {.meaning = std::move(meaning)}; }
inline ParameterFacts range(const char* unit, double min, double max, std::string meaning) {
  return {.unit = unit, .min = min, .max = max, .meaning = std::move(meaning)};
}
/// A number above 0.
inline ParameterFacts positive(const char* unit, double max, std::string meaning) {
  return {.unit = unit, .above = 0, .max = max, .meaning = std::move(meaning)};
}
/// A coordinate or an offset, m.
inline ParameterFacts metres(std::string meaning) {
  return range("m", -1e4, 1e4, std::move(meaning));
}
/// The smallest mass; below it and kLeastLength, rounding would spoil moments of inertia.
inline constexpr double kLeastMass = 1e-6;  // kg
inline ParameterFacts mass(std::string meaning, double max = 1e4) {
  return range("kg", kLeastMass, max, std::move(meaning));
}
inline ParameterFacts size(std::string meaning, double max = 1e3) {
  return range("m", kLeastLength, max, std::move(meaning));
}
inline ParameterFacts angle(std::string meaning) {
  return range("deg", -360, 360, std::move(meaning));
}

/// An element that uses a plugin of this kind. `id`: the meaning of its id.
template <class Use>
Describe<Use> plugin_use(const char* name, const std::string& meaning, PluginKind kind, Cost cost,
                         const char* id) {
  return Describe<Use>(name, meaning + ": the element has the name of its plugin")
      .plugins(kind)
      .costs(cost)
      .attribute("id", &PluginUse::id, fact(id), kId);
}

/// A root element with the version of the vocabulary; the reader checks the version first.
template <class Object>
Describe<Object> root(const char* name, const char* meaning, int version = kFormat) {
  return Describe<Object>(name, meaning)
      .root()
      .attribute(
          "format", ParameterType::text,
          {.choices = {std::to_string(version)}, .meaning = "version of this vocabulary"},
          kRequired, [](void*, const ParameterValue&) {},
          [version](const void*) -> std::optional<ParameterValue> {
            return std::to_string(version);
          });
}

}  // namespace elsie::world

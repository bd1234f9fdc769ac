// Checks and sets parameters of plugins.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/declaration.h"

namespace elsie::plugin {

/// The parameter or element of this name in a declaration's list, or null.
template <class Declared>
const Declared* find_declared(const std::vector<Declared>& list, std::string_view name) {
  for (const Declared& declared : list) {
    if (declared.name == name) return &declared;
  }
  return nullptr;
}

/// Gives a behaviour that may hold others an empty Coordination, to try out its parameters.
void hold_nothing(const Declaration& declaration, Component& object);

/// The shortest text that reads back as the same value.
std::string format_value(const ParameterValue& value);

/// The allowed values in words: "a number at least 0 and at most 50 rad/s", "one of 'low', 'high'".
std::string allowed_values(const ParameterDeclaration& parameter);

/// A sentence if the value is not allowed: another type, out of range, not among the choices, not
/// finite. "speed is 60 rad/s, but must be a number at least 0 and at most 50 rad/s".
std::optional<std::string> check_value(const ParameterDeclaration& parameter,
                                       const ParameterValue& value);

/// Sets the given parameters of an object that `declaration` made; the others keep their values.
/// Nested elements replace those of their lists; other lists stay. Then calls configured(), even if
/// nothing was given. Throws PluginError with every wrong name and value, before anything is set,
/// or with the message of an exception that configured() throws.
void apply_parameters(const Declaration& declaration, Component& object,
                      const std::map<std::string, ParameterValue>& parameters,
                      const std::vector<ElementValue>& elements = {});

}  // namespace elsie::plugin

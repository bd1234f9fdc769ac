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

/// What a parameter, or an attribute of the core's own elements, may be: a view of its declaration.
struct Allowed {
  template <class Declared>
  Allowed(const Declared& declared)  // NOLINT(google-explicit-constructor)
      : type(declared.type),
        facts(declared.facts),
        lowest(declared.lowest),
        highest(declared.highest) {}

  ParameterType type;
  const ParameterFacts& facts;
  double lowest, highest;  // the range of the member's type
};

/// The allowed values in words: "a number at least 0 and at most 50 rad/s", "one of 'low', 'high'".
std::string allowed_values(const Allowed& allowed);

struct Parsed {
  std::optional<ParameterValue> value;
  std::string expected;  // if there is none: what was expected instead of the text, and why
};

/// Parses a value strictly: the whole text must be one value, finite and in range. Decimal commas,
/// and "yes" for true, are errors.
Parsed parse_value(const Allowed& allowed, std::string_view text);
/// The shortest text that parse_value() reads as the same value.
std::string format_value(const ParameterValue& value);

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

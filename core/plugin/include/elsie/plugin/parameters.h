// Parameters of plugins: what is allowed, and setting them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "elsie/api/declaration.h"

namespace elsie::plugin {

/// What the parameter takes, in words: "a number at least 0 and at most 50 rad/s", "one of
/// 'low', 'high'".
std::string allowed_values(const ParameterDeclaration& parameter);

/// A sentence when the parameter must not have this value: of another type than declared, out of
/// range, not among the choices, not finite. "speed is 60 rad/s, but must be a number at least 0
/// and at most 50 rad/s". None when the value is fine.
std::optional<std::string> check_value(const ParameterDeclaration& parameter,
                                       const ParameterValue& value);

/// Sets the given parameters of an object that `declaration` made; the others keep the values that
/// they have. Nested elements replace those of the lists that they belong to; other lists stay as
/// they are. Then calls configured(), also when nothing was given. Throws PluginError that tells of
/// every wrong name and value at once, in which case nothing was set; or of what configured()
/// threw.
void apply_parameters(const Declaration& declaration, Component& object,
                      const std::map<std::string, ParameterValue>& parameters,
                      const std::vector<ElementValue>& elements = {});

}  // namespace elsie::plugin

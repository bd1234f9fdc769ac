// Attributes' values and their texts.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "elsie/plugin/parameters.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

struct Parsed {
  std::optional<ParameterValue> value;  // none: `problem` says why
  std::string problem;
};

/// Strict: the whole text must be a value, finite and in range; no decimal commas, no "yes" for
/// true.
Parsed parse_value(const Field& field, std::string_view text);

/// The shortest text that parse_value() reads as the same value.
using plugin::format_value;

/// The values that a field allows, in words: "a number above 0 and at most 10 m".
std::string expectation(const Field& field);

std::string format_colour(const Colour& colour);
/// The text must have passed parse_value().
Colour colour_of(std::string_view text);

}  // namespace elsie::world

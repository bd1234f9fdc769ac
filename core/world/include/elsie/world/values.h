// The values of attributes as text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "elsie/plugin/parameters.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

struct Parsed {
  std::optional<ParameterValue> value;  // none: `problem` has the reason
  std::string problem;
};

/// Parses a value strictly: the whole text must be one value, finite and in range. Decimal commas,
/// and "yes" for true, are errors.
Parsed parse_value(const Field& field, std::string_view text);

/// The shortest text that parse_value() reads as the same value.
using plugin::format_value;

/// The values that a field allows, in words: "a number above 0 and at most 10 m".
std::string expectation(const Field& field);

std::string format_colour(const Colour& colour);
/// The colour that a text names, which parse_value() must have accepted.
Colour colour_of(std::string_view text);

}  // namespace elsie::world

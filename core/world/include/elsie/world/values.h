// Texts of attributes and the values they stand for.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "elsie/api/declaration.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

struct Parsed {
  std::optional<ParameterValue> value;  // none: `problem` says why
  std::string problem;
};

/// Strict: the whole text, finite, within range; nothing that only begins like a number, no decimal
/// commas, no "yes" for true.
Parsed parse_value(const Field& field, std::string_view text);

/// The text that parse_value() turns into the same value; numbers with as few digits as that takes.
std::string format_value(const ParameterValue& value);

/// What a field accepts, in words: "a number above 0 and at most 10 m".
std::string expectation(const Field& field);

std::string format_colour(const Colour& colour);
/// The text must have passed parse_value().
Colour colour_of(std::string_view text);

}  // namespace elsie::world

// The values of attributes as text.
#pragma once

#include <string>
#include <string_view>

#include "elsie/plugin/parameters.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

using plugin::format_value;
using plugin::Parsed;

/// plugin::parse_value(), and the check of the field's form.
Parsed parse_value(const Field& field, std::string_view text);

/// The values that a field allows, in words: "a number above 0 and at most 10 m".
std::string expectation(const Field& field);

std::string format_colour(const Colour& colour);
/// The colour that a text names, which parse_value() must have accepted.
Colour colour_of(std::string_view text);

}  // namespace elsie::world

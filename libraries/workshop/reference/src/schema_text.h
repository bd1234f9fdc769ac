// Parts of a schema that do not depend on vocabularies: markup, and the values of attributes.
#pragma once

#include <cstddef>
#include <string>

#include "elsie/world/vocabulary.h"

namespace elsie::reference {

std::string indented(const std::string& text, std::size_t depth);
std::string documentation(const std::string& text, std::size_t depth);

/// The basic types of all attributes: stricter than XML Schema's own, which accept NaN, INF, a
/// leading "+", and 1 for true.
std::string basic_types();

/// The declaration of an attribute.
std::string schema_attribute(const world::Field& field);

}  // namespace elsie::reference

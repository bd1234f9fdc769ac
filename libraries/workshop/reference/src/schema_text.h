// The parts of a schema that know nothing of vocabularies: markup, and what may stand in an
// attribute.
#pragma once

#include <cstddef>
#include <string>

#include "elsie/world/vocabulary.h"

namespace elsie::reference {

std::string indented(const std::string& text, std::size_t depth);
std::string documentation(const std::string& text, std::size_t depth);

/// The types that the facets of every attribute start from: stricter than XML Schema's own, which
/// take NaN, INF, a leading "+", and 1 for true.
std::string basic_types();

/// The declaration of an attribute.
std::string schema_attribute(const world::Field& field);

}  // namespace elsie::reference

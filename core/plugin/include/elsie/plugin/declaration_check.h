// Whether what a plugin says of itself makes sense.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/declaration.h"

namespace elsie::plugin {

/// Whether the name may stand for an attribute or an id in a world file: a small letter, then small
/// letters, digits and underscores.
bool is_plain_name(std::string_view name);

/// The faults of a declaration, each a sentence that names the plugin; empty when there is none.
/// Looked at are: names; that parameters, events and readings are not said twice; ranges; that each
/// default is allowed; that a sensor produces one kind of reading and needs none, and nothing else
/// produces any; that a measure needs none and raises no events.
std::vector<std::string> check_declaration(const Declaration& declaration);

/// The faults of all declarations of one library, among them two plugins of the same kind and name.
std::vector<std::string> check_declarations(std::span<const Declaration> declarations);

}  // namespace elsie::plugin

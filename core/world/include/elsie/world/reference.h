// Reference pages made of the declarations.
#pragma once

#include <string>

#include "elsie/api/declaration.h"

namespace elsie::world {

/// The vocabulary of world files, in Markdown: every element with its attributes.
std::string world_reference();

/// A plugin, in Markdown: what it does, its parameters, readings and events.
std::string plugin_reference(const Declaration& declaration);

}  // namespace elsie::world

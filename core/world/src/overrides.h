// --set PATH=VALUE: changes to the tree of a world before it is checked.
#pragma once

#include <string>

#include "elsie/world/error.h"
#include "elsie/world/markup.h"

namespace elsie::world {

/// Whether an override must come before templates are merged: that of a robot's template, and those
/// that replace robots.
bool concerns_templates(const std::string& override);

/// Applies "PATH=VALUE" to the tree of a world, whose ids are complete. What `@remove` takes away
/// stays there, marked, until remove_overridden(): numbers in the paths of later overrides count
/// it, too.
void apply_override(Element& world, const std::string& override, Problems& problems);

/// Takes out what overrides have marked.
void remove_overridden(Element& world);

}  // namespace elsie::world

// --set PATH=VALUE: changes the tree of a world before it is checked.
#pragma once

#include <string>

#include "elsie/world/error.h"
#include "elsie/world/markup.h"

namespace elsie::world {

/// Whether an override is applied before templates: one of a robot's template, or one that replaces
/// robots.
bool concerns_templates(const std::string& override);

/// Whether an override sets the template of a robot that is there.
bool sets_template(const std::string& override);

/// Whether an override adds, replaces or removes robots, or sets their templates.
bool concerns_robots(const std::string& override);

/// Applies "PATH=VALUE" to the tree of a world, whose ids are complete. Elements that `@remove`
/// removes are only marked, since numbers in later paths count them, too.
///
/// `is_running`: the tree is that of what runs, in which defaults are not given: an attribute that
/// has its default may be taken away as well.
void apply_override(Element& world, const std::string& override, bool is_running,
                    Problems& problems);

/// Removes the marked elements.
void remove_overridden(Element& world);

}  // namespace elsie::world

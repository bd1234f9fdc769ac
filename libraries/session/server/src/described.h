// Descriptions of documents and worlds for messages.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "elsie/base/problems.h"
#include "elsie/editing/document.h"
#include "elsie/plugin/host.h"

#include "link.h"

namespace elsie::server {

Json problems_json(std::span<const base::Problem> problems);
/// A single problem, of no file.
Json problem_json(const std::string& sentence);

/// The warnings of `elsie check` about settings that the physics may not simulate well.
Json warnings_json(const world::World& world);

/// The elements of the document's world. `inherited`: the element is in the template of a robot;
/// `written`: a robot without the content of its template.
Json tree_json(const editing::Document& document);

/// The vocabulary of worlds, all plugins and all events.
Json catalog_json(const plugin::Host& host);

}  // namespace elsie::server

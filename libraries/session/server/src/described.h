// What messages say of documents and worlds.
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

/// What the physics may not simulate well, as `elsie check` says it.
Json warnings_json(const world::World& world);

/// The elements of the document's world; `inherited`: one stands in the template of a robot;
/// `written`: a robot without what its template adds.
Json tree_json(const editing::Document& document);

/// The vocabulary of worlds, the plugins and the events.
Json catalog_json(const plugin::Host& host);

/// What is wrong with a text, and what the physics may not simulate well, as `elsie check` says it.
Json check_json(const std::string& text, const std::string& file, const plugin::Host& host,
                const world::ReadOptions& options);

}  // namespace elsie::server

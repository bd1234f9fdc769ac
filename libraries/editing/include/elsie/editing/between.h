// The edits that lead from one world to another.
#pragma once

#include <string>
#include <vector>

#include "elsie/world/reader.h"

namespace elsie::editing {

/// Edits after which `from` is `to`, made together or one after the other: as few and as small as
/// the paths of ReadOptions::overrides allow. Elements keep their identity by their ids; of two
/// elements without ids those that say the same are one. They are tried before they are returned:
/// throws WorldError if there are none. `options` say how worlds are read; its overrides are not
/// used.
std::vector<std::string> edits_between(const world::World& from, const world::World& to,
                                       const plugin::Host& host,
                                       const world::ReadOptions& options = {});

/// Whether these edits, made together, lead there.
bool lead_to(const world::World& to, const world::World& from,
             const std::vector<std::string>& edits, const plugin::Host& host,
             world::ReadOptions options = {});

}  // namespace elsie::editing

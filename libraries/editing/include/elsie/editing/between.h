// The edits that lead from one world to another.
#pragma once

#include <string>
#include <vector>

#include "elsie/world/reader.h"

namespace elsie::editing {

/// Edits that turn `from` into `to`, made together or one after the other: as few and as small as
/// the paths of ReadOptions::overrides allow. Elements are matched by their ids; elements without
/// ids match if their contents are equal. The edits are tested before they are returned. Throws
/// WorldError if no edits lead from `from` to `to`. `options` say how worlds are read; its
/// overrides are not used.
std::vector<std::string> edits_between(const world::World& from, const world::World& to,
                                       const plugin::Host& host,
                                       const world::ReadOptions& options = {});

/// Whether these edits, made together, turn `from` into `to`.
bool lead_to(const world::World& to, const world::World& from,
             const std::vector<std::string>& edits, const plugin::Host& host,
             world::ReadOptions options = {});

}  // namespace elsie::editing

// Reading a world file: XML in, a checked description out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "elsie/world/description.h"
#include "elsie/world/error.h"

namespace elsie::plugin {
class Host;
}

namespace elsie::world {

struct ReadOptions {
  /// Attributes to change before anything is checked, each "PATH=VALUE"; see docs/world-paths.md
  /// for the paths, e.g. "robot[r1]/behavior[avoid_obstacle]/@priority=3".
  std::vector<std::string> overrides;
  /// Where templates and data files are looked for when they are not beside the file that names
  /// them, in this order.
  std::vector<std::string> data_directories;
  /// Whether to make every plugin's object once, so that what it says about its parameters in
  /// Component::configured() is reported too.
  bool check_plugins = false;
};

/// Reads a world file, with its templates merged in, overrides applied and every default filled in.
/// Throws WorldError with all the problems of the file; nothing half read is ever returned.
///
/// The result's file parameters hold absolute paths of files that exist. Obstacles stand before
/// resources in World::boxes.
World read_world(const std::string& file, const plugin::Host& host,
                 const ReadOptions& options = {});

/// The same for text that is in memory; `file` is what it is called in messages, and its folder is
/// where templates and data files are looked for first.
World parse_world(std::string_view text, const std::string& file, const plugin::Host& host,
                  const ReadOptions& options = {});

}  // namespace elsie::world

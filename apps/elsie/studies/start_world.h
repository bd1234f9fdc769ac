// The world at the start of a run, as a file that makes the same run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "elsie/plugin/host.h"
#include "elsie/world/reader.h"

#include "environment.h"

namespace elsie::program {

/// A run whose world is to be written.
struct RunToWrite {
  std::string world_text;  // with the run's edits under <changes>
  std::string world_file;  // where it was read; names of files start there
  std::uint64_t seed = 1;
  double time_limit_s = 0.0;  // 0: that of the world
};

struct StartWorld {
  std::string command;               // that makes the run
  std::optional<double> duration_s;  // the run's, where the world's time limit is another one

  /// For a person, with an empty line after it.
  std::string in_words() const { return "the same run: " + command + "\n\n"; }
};

/// Throws BadInput if the file is there already or cannot be written.
void require_new_world(const std::string& file);

/// Writes the world completely or not at all, changes names of files so that they lead to the same
/// files from there. Throws BadInput if the file cannot be written.
///
/// If files no longer fit the world, it is written as it was; reading it then reports what is
/// missing.
StartWorld write_start_world(const RunToWrite& run, const plugin::Host& host,
                             const world::ReadOptions& reading, const PluginOptions& plugins,
                             const std::string& file);

}  // namespace elsie::program

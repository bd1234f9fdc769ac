// Restores a stored run as far as its files still exist.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "elsie/batch/results_database.h"
#include "elsie/plugin/host.h"
#include "elsie/world/description.h"

#include "environment.h"

namespace elsie::program {

/// Data files that have changed on disk are taken from the database. Plugins are taken from the
/// libraries of the original run unless the user names others; if they no longer exist, from the
/// search path.
class RestoredRun {
 public:
  /// Throws BadInput, and world::WorldError when a plugin cannot be found.
  /// `kept`: a folder for restored data files, which is created if there are any and stays; none: a
  /// folder that is removed with this object.
  RestoredRun(const batch::StoredRun& run, const PluginOptions& plugins,
              std::optional<std::filesystem::path> kept = {});
  ~RestoredRun();
  RestoredRun(const RestoredRun&) = delete;
  RestoredRun& operator=(const RestoredRun&) = delete;

  const world::World& world() const { return world_; }
  const plugin::Host& host() const { return host_; }
  /// Paths of its data files, by their names in the world and its edits.
  const std::map<std::string, std::string>& files() const { return files_; }
  /// Sentences on differences from the original run.
  const std::vector<std::string>& differences() const { return differences_; }

 private:
  void restore_data(const batch::StoredRun& run);
  void compare_program(const batch::StoredRun& run);
  void compare_libraries(const batch::StoredRun& run);

  std::vector<std::string> differences_;
  std::map<std::string, std::string> files_;
  std::optional<std::filesystem::path> kept_;
  std::filesystem::path folder_;  // of restored data files; empty: none
  plugin::Host host_;
  world::World world_;
};

}  // namespace elsie::program

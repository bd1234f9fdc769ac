// Which plugins a test works with, and what it sets of them.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "elsie/api/declaration.h"
#include "elsie/plugin/error.h"
#include "elsie/plugin/host.h"

namespace elsie::testing {

/// Parameters by name, as a world file would give them: {{"comfort", 0.4}, {"slot", 2}}. A whole
/// number will do for a real one.
using Settings = std::map<std::string, ParameterValue>;

/// Elements nested in a plugin's: {{"suppress", {{"by", "escape"}, {"of", "wander"}}}}.
using Elements = std::vector<ElementValue>;

/// The plugins that were found. Copies share them; whatever a test makes of them keeps them loaded.
class Plugins {
 public:
  /// Those of the search path: ELSIE_PLUGIN_PATH, the folder of the test program, the plugins that
  /// are installed with Elsie.
  Plugins();
  /// Library files, sources of one file (.cpp), which are compiled first, or folders with
  /// libraries, before the search path. Throws plugin::PluginError, with a sentence, for a file
  /// that is refused and for a place that does not exist.
  explicit Plugins(std::initializer_list<std::filesystem::path> places);
  explicit Plugins(const std::vector<std::filesystem::path>& places);
  /// Exactly these.
  explicit Plugins(plugin::Host host);

  /// Those of the search path, loaded once for the whole program.
  static const Plugins& found();

  const plugin::Host& host() const { return *host_; }
  /// Throws plugin::PluginError, with the nearest right name, when there is no such plugin.
  const Declaration& declaration(PluginKind kind, const std::string& name) const;
  /// What a plugin is to be given: file parameters found, in the working directory or in
  /// data_directories(); whole numbers made real ones. Throws plugin::PluginError for a file that
  /// is not there, and for a required parameter that is missing.
  Settings completed(const Declaration& declaration, const Settings& settings) const;
  /// The same for nested elements.
  Elements completed(const Declaration& declaration, const Elements& elements) const;

 private:
  std::shared_ptr<const plugin::Host> host_;
};

/// Where worlds and plugins find data files: world::default_data_directories().
std::vector<std::string> data_directories();

}  // namespace elsie::testing

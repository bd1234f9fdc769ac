// The plugins that a test uses, and their parameters.
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

/// Parameters by name, as in a world file: {{"comfort", 0.4}, {"slot", 2}}. Real parameters also
/// take whole numbers.
using Settings = std::map<std::string, ParameterValue>;

/// Elements inside of a plugin's element: {{"suppress", {{"by", "escape"}, {"of", "wander"}}}}.
using Elements = std::vector<ElementValue>;

/// A set of plugins. Copies share it; objects made from it keep their libraries loaded.
class Plugins {
 public:
  /// The plugins of the search path: ELSIE_PLUGIN_PATH, the folder of the test program, the plugins
  /// installed with Elsie.
  Plugins();
  /// First library files, sources of one file (.cpp), which are compiled, or folders with
  /// libraries; then the search path. Throws plugin::PluginError with a sentence for a file that is
  /// refused and for a missing place.
  explicit Plugins(std::initializer_list<std::filesystem::path> places);
  explicit Plugins(const std::vector<std::filesystem::path>& places);
  /// Only these plugins.
  explicit Plugins(plugin::Host host);

  /// The plugins of the search path, loaded once for the whole program.
  static const Plugins& found();

  const plugin::Host& host() const { return *host_; }
  /// Throws plugin::PluginError with the nearest name when there is no such plugin.
  const Declaration& declaration(PluginKind kind, const std::string& name) const;
  /// The parameters that the plugin gets: file parameters with paths in the working directory or in
  /// data_directories(); whole numbers converted for real parameters. Throws plugin::PluginError
  /// for a missing file and for a missing required parameter.
  Settings completed(const Declaration& declaration, const Settings& settings) const;
  /// The same for nested elements.
  Elements completed(const Declaration& declaration, const Elements& elements) const;

 private:
  std::shared_ptr<const plugin::Host> host_;
};

/// The folders of data files: world::default_data_directories().
std::vector<std::string> data_directories();

}  // namespace elsie::testing

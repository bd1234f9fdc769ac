// The error of this module.
#pragma once

#include <stdexcept>

namespace elsie::plugin {

/// A plugin that does not exist, or that failed while it was made or given its parameters. what()
/// is a sentence that names the plugin and the file that it comes from. Nothing of it refers to
/// memory of the plugin's library.
class PluginError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A plugin whose constructor throws: nobody who writes a world can mend that.
class CreateError : public PluginError {
 public:
  using PluginError::PluginError;
};

}  // namespace elsie::plugin

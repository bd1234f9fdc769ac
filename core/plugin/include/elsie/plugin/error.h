// The error of this module.
#pragma once

#include "elsie/base/error.h"

namespace elsie::plugin {

/// A plugin does not exist, or failed while it was made or given its parameters. what() is a
/// sentence that names the plugin and its file. No part of it is memory of the plugin's library.
class PluginError : public base::Error {
 public:
  explicit PluginError(const std::string& sentence, base::ExitCode exit_code = base::kBadInput)
      : Error(sentence, exit_code) {}
};

/// A plugin's constructor throws; no change to a world can avoid this.
class CreateError : public PluginError {
 public:
  explicit CreateError(const std::string& sentence) : PluginError(sentence, base::kPluginFailed) {}
};

}  // namespace elsie::plugin

// The error of this module.
#pragma once

#include "elsie/base/error.h"

namespace elsie::plugin {

/// A plugin that does not exist, or that failed while it was made or given its parameters. what()
/// is a sentence that names the plugin and the file that it comes from. Nothing of it refers to
/// memory of the plugin's library.
class PluginError : public base::Error {
 public:
  explicit PluginError(const std::string& sentence, base::ExitCode exit_code = base::kBadInput)
      : Error(sentence, exit_code) {}
};

/// A plugin whose constructor throws: nobody who writes a world can mend that.
class CreateError : public PluginError {
 public:
  explicit CreateError(const std::string& sentence) : PluginError(sentence, base::kPluginFailed) {}
};

}  // namespace elsie::plugin

// Running another program and reading what it says.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace elsie::plugin {

struct ProcessResult {
  int exit_code = 0;   // 128 and the number of the signal, when one ended it
  std::string output;  // both streams, as they came
};

/// Runs the program, which is looked for in $PATH, with these arguments (the first is its name) and
/// waits for its end. None when it cannot be started.
std::optional<ProcessResult> run_process(const std::vector<std::string>& arguments);

}  // namespace elsie::plugin

// Running another program and reading what it says.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace elsie::process {

struct ProcessResult {
  int exit_code = 0;   // 128 and the number of the signal, when one ended it
  std::string output;  // both streams, as they came
};

/// Runs the program, which is looked for in $PATH, with these arguments (the first is its name) and
/// waits for its end. None when it cannot be started. `stop` asks it, and what it has started, to
/// terminate; so does the end of this process if it is brought down (crash_report.h).
std::optional<ProcessResult> run_process(const std::vector<std::string>& arguments,
                                         const std::stop_token& stop = {});

}  // namespace elsie::process

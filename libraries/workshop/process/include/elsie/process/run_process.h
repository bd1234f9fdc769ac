// Runs another program and reads its output.
#pragma once

#include <csignal>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace elsie::process {

struct ProcessResult {
  int exit_code = 0;   // or 128 and the number of the signal that ended it
  std::string output;  // both streams, interleaved
};

/// Runs the program, searched for in $PATH, with these arguments (the first is its name) and waits
/// for its end. None when it cannot be started. `stop` sends it and its children the signal, and so
/// does a crash of this process (crash_report.h): SIGKILL for what may take no other.
std::optional<ProcessResult> run_process(const std::vector<std::string>& arguments,
                                         const std::stop_token& stop = {}, int signal = SIGTERM);

}  // namespace elsie::process

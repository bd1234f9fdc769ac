// What a worker does, whether it is a program of its own or a copy of one.
#pragma once

#include <optional>

#include "elsie/batch/job.h"
#include "elsie/plugin/host.h"

namespace elsie::batch {

/// The name of a process that does a run, as ps(1) shows it.
inline constexpr const char* kNameOfRuns = "elsie-run";

/// The job on standard input. Ends the process if there is none.
Job job_on_input();

/// As work(), with the libraries of the job if they are loaded already. Crashes of the process must
/// be reported.
[[noreturn]] void do_run(std::optional<plugin::Host> loaded);

}  // namespace elsie::batch

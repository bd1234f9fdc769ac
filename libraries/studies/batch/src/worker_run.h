// What a worker does, whether it is a program of its own or a copy of one.
#pragma once

#include <memory>

#include "elsie/batch/job.h"
#include "elsie/batch/perform.h"

namespace elsie::batch {

/// The name of a process that does a run, as ps(1) shows it.
inline constexpr const char* kNameOfRuns = "elsie-run";

/// The job on standard input. Ends the process if there is none.
Job job_on_input();

/// From now on the process reports the plugin at work and ends when the pool asks it to, by
/// SIGXCPU.
void handle_requests_to_end();

/// As work(), for this job, of which something may be prepared; see perform(). Crashes and requests
/// to end must be handled.
[[noreturn]] void do_run(const Job& job, std::unique_ptr<Preparation> prepared = nullptr);

}  // namespace elsie::batch

// The worker's side of WorkerPool: a process that does one run, and one that is copied for runs.
#pragma once

namespace elsie::batch {

/// Reads the job from standard input, does it, answers on kResultDescriptor, and ends the process.
/// Exit codes: 0 the run ended, 2 there was no job, 3 a plugin failed, 4 another failure. The
/// process must do nothing else. If a plugin ends the process, or SIGXCPU arrives because the run
/// takes too long, the worker still reports which plugin was running.
[[noreturn]] void work();

/// Reads a job from standard input, loads its libraries, and makes a copy of this process for each
/// run that the pool asks for on kResultDescriptor; see run_template.h. A copy does the same as
/// work(). Ends when the pool ends. The process must do nothing else, and have one thread.
[[noreturn]] void stand_by();

}  // namespace elsie::batch

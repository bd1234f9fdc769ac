// The worker's side of WorkerPool: a process that does one run.
#pragma once

namespace elsie::batch {

/// Reads the job from standard input, does it, answers on kResultDescriptor, and ends the process.
/// Exit codes: 0 the run ended, 3 a plugin failed, 4 another failure, 2 there was no job. The
/// process must do nothing else. When a plugin ends the process, or SIGTERM comes because the run
/// takes too long, it still reports the plugin at work.
[[noreturn]] void work();

}  // namespace elsie::batch

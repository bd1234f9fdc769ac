// The worker's side of WorkerPool: a process that does one run.
#pragma once

namespace elsie::batch {

/// Does the job that is on standard input, answers on kResultDescriptor, and ends the process: with
/// exit code 0 when the run ended by itself, 3 when a plugin failed, else 4; 2 when there was no
/// job. To be all that the process does. When a plugin brings it down, or SIGTERM comes because the
/// run takes too long, it still says who was at work.
[[noreturn]] void work();

}  // namespace elsie::batch

// Starts the processes of a pool: programs with three descriptors, each in its own process group.
#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

#include "elsie/batch/job.h"

#include "descriptor.h"

namespace elsie::batch {

/// Throws std::runtime_error: no worker can be started, because this call failed (errno).
[[noreturn]] void cannot_start(const char* call);

/// The job as a file in memory, positioned at its start. Throws as cannot_start().
Descriptor file_of(const Job& job);

/// Starts a program with SIGTERM blocked. Its standard input is `input`, its two outputs `output`,
/// and `answer` its descriptor kResultDescriptor. `variable`: "NAME=value", added to its
/// environment. It ends with this process. Throws as cannot_start().
pid_t start_process(const std::vector<std::string>& command, const Descriptor& input,
                    const Descriptor& output, const Descriptor& answer,
                    const char* variable = nullptr);

/// Kills a child, if it still runs, and its process group. Returns its status as waitpid(2) does.
int end_process_group(pid_t process);

}  // namespace elsie::batch

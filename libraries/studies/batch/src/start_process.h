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

/// A variable of the environment for the system's loader, and the value that Binding::now gives it.
inline constexpr const char* kBindNow = "LD_BIND_NOW";
inline constexpr const char* kBoundForCopies = "copies";

/// When the system's loader looks up the addresses of functions: for each at its first call, or for
/// all at the start, so that copies of the process need not do it.
enum class Binding { lazy, now };

/// Starts a program that ignores SIGTERM. Its standard input is `input`, its two outputs `output`,
/// and `answer` its descriptor kResultDescriptor. It ends with this process. Throws as
/// cannot_start().
pid_t start_process(const std::vector<std::string>& command, const Descriptor& input,
                    const Descriptor& output, const Descriptor& answer,
                    Binding binding = Binding::lazy);

/// Kills a child, if it still runs, and its process group. Returns its status as waitpid(2) does.
int end_process_group(pid_t process);

}  // namespace elsie::batch

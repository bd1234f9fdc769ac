// Shared by crash_report.cpp and watchdog.cpp: reports the end of the process from a signal
// handler.
#pragma once

#include <csignal>

#include "stack_trace.h"

namespace elsie::process {

/// Whether this thread is the first to report; false if it has begun before, so that its report
/// itself has crashed. If another thread reports, this one waits for the end.
bool may_report() noexcept;

/// Writes one line: the plugin at work, `what` it did, and when. `library`: of a thread that a
/// plugin has started; null: it is found from the calls of this thread.
void write_culprit_and(const char* what, const char* library);

/// Writes the same line, recorded data, and the stack. Returns whether a plugin caused it.
bool write_report(const char* what, const Fault& place);

/// `context`: the third argument of a signal handler.
Fault place_of_fault(const void* context);

/// Sets a handler.
void handle(int signal, void (*handler)(int, siginfo_t*, void*), int flags);

}  // namespace elsie::process

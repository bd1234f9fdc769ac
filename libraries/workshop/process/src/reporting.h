// What crash_report.cpp and watchdog.cpp have in common: reporting the end of the process, within a
// handler of a signal.
#pragma once

#include <csignal>

#include "stack_trace.h"

namespace elsie::process {

/// Whether this thread is the first one that reports; false when it has begun to before, so that
/// its report itself has crashed. If another thread reports, this one waits for the end.
bool may_report() noexcept;

/// One line: who was at work, `what` it did, and when. `library`: of a thread that a plugin has
/// started; null: it is looked for among the calls of this thread.
void write_culprit_and(const char* what, const char* library);

/// The same, what was recorded, and the stack. Returns whether it was a plugin's doing.
bool write_report(const char* what, const Fault& place);

/// `context`: the third argument of a handler of signals.
Fault place_of_fault(const void* context);

/// Sets a handler.
void handle(int signal, void (*handler)(int, siginfo_t*, void*), int flags);

}  // namespace elsie::process

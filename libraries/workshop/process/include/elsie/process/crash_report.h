// Reports the end of a process that a plugin causes.
//
// A segmentation fault in a plugin cannot be caught like an exception: the process must end. This
// module reports which plugin it was, and where, and writes what was recorded before. All of this
// is done in the signal handler, without allocation. The stack trace takes the lock of the system's
// loader.
#pragma once

#include <thread>

namespace elsie::plugin {
struct CallFacts;  // call.h
}

namespace elsie::process {

/// Reports signals that end the process because of an error (SIGSEGV, SIGBUS, SIGILL, SIGFPE,
/// SIGABRT, SIGTRAP, SIGSYS) on standard error from now on: plugin, robot, step (Call), the signal,
/// and a stack trace with lines of the source if available. Data in files::EmergencyWriters is
/// written to its files. Then:
///
/// - in a plugin's code, also in a thread that a plugin has started, the process ends with
///   `exit_status`, whatever the signal;
/// - elsewhere the process ends by the signal, as without this function.
///
/// The same holds when the report itself crashes, as on an overwritten stack. Another thread that
/// crashes meanwhile waits for the end. A copy of the process that a plugin makes with fork() ends
/// silently when the plugin returns in it (Call::has_forked()). Any other signal that ends a
/// process (SIGUSR1, SIGALRM, SIGRTMIN...) is reported likewise if this process sent it, or one of
/// its timers did, as only plugins do, and SIGQUIT if a plugin is at work. From elsewhere it still
/// ends the process, but after a clean-up. Requests to end it (SIGINT, SIGTERM, SIGHUP) are left to
/// the program.
///
/// Exceptions that note_throw() sees are reported with the line of the plugin that threw them
/// (base::place_of_throw()).
///
/// A stack overflow is reported in the calling thread only, which gets a second stack for it. To be
/// called once, early, by a program, never by a library.
void report_crashes(int exit_status);

/// Makes a copy of the process, in which it must be called first, report its crashes like the
/// original. To be called by a program that has copied itself on purpose.
void report_crashes_of_copy();

/// For programs that define the C library's functions that end a process (exit(), _exit(), _Exit(),
/// quick_exit()) themselves, so that a plugin which calls one is named. Reports the call of
/// `function` ("_exit()") like a crash, and ends the process with the exit status of crashes.
/// `caller`: an address in the calling code, which names the library when no plugin is known to be
/// at work. In a child made by fork(), it ends the child with `exit_code` and reports nothing.
[[noreturn]] void report_exit(const char* function, int exit_code, const void* caller) noexcept;

/// For programs that define __cxa_throw() themselves: notes the calls that led to the exception, if
/// a plugin is at work. Takes some microseconds then.
void note_throw(const void* exception) noexcept;

/// Ends the process like a crash, from a signal handler. If a plugin is at work in this thread, or
/// in one that shares its work (Call::show_thread()), reports `what` it did: "did not return".
/// Otherwise writes `else_say`. The stack is that of this thread; without it, only one line is
/// written, and while plugins are being loaded, and have been for less than a second, it says so.
enum class Stack { shown, left_out };
[[noreturn]] void end_process(const char* what, const char* else_say, int exit_status,
                              Stack stack = Stack::shown);

/// Ends the process when a call of the thread that made this takes too long, because a plugin that
/// does not return cannot be stopped otherwise. Only calls with a started clock count
/// (Call::start_clock()).
class Watchdog {
 public:
  /// `limit_s`: the limit of a call's own time, s; positive. `exit_status`: of the process. The
  /// report comes from the thread itself, by a signal. `what` follows the plugin's name in the
  /// report, and must live as long as this.
  Watchdog(double limit_s, int exit_status,
           const char* what = "did not return within its time budget and was stopped");
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

 private:
  std::jthread outside_;
};

/// The plugin at work in this thread, from the innermost call and those around it; all null when
/// there is none. For signal handlers and EmergencyWriters.
plugin::CallFacts facts_at_work() noexcept;

/// The signal of the crash that is being reported; 0: none, as when a plugin calls exit().
int signal_of_crash() noexcept;

}  // namespace elsie::process

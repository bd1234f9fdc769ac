// The last words of a process that a plugin brings down.
//
// A segmentation fault in a plugin cannot be caught like an exception: the process has to end. What
// can be done is to say whose it was, and where, and to write down what was recorded until then.
// All of it is done within the handler of the signal, without allocating. The stack trace takes the
// lock of the system's loader.
#pragma once

#include <thread>

namespace elsie::plugin {
struct CallFacts;  // call.h
}

namespace elsie::process {

/// From now on a signal that ends the process because of an error (SIGSEGV, SIGBUS, SIGILL, SIGFPE,
/// SIGABRT) is reported on standard error: plugin, robot, step (Call), the signal, and a stack
/// trace with lines of the source where they can be found out. Files that were handed to
/// base::EmergencyWriter are written. Then:
///
/// - in a plugin's code, also in a thread that a plugin has started, the process ends with
///   `exit_status`, whatever the signal, and so it does when a plugin calls exit();
/// - elsewhere the process ends by the signal, as it would without this.
///
/// The same holds when the report itself crashes, as on a stack that was written over. Another
/// thread that crashes meanwhile waits for the end. A copy of the process that a plugin makes with
/// fork() ends, without a word, as soon as the plugin returns in it (Call::has_forked()). Other
/// signals that end a process and are not handled (SIGPIPE, SIGQUIT, SIGXCPU, SIGUSR1...) end it as
/// always, but after a clean-up.
///
/// A stack that has overflowed is reported in the thread that calls this, which gets a second stack
/// for it. To be called once, early, by a program; a library never does.
void report_crashes(int exit_status);

/// For programs that put functions of their own before those of the C library that end a process
/// (_exit(), _Exit(), quick_exit()), so that a plugin which calls one is named: reports the call of
/// `function` ("_exit()") as a crash is reported, and ends the process with the exit status of
/// crashes. `caller`: an address in the code that calls it, by which the library is named when no
/// plugin is known to be at work. In a child that fork() has made, it ends the child with
/// `exit_code` and says nothing.
[[noreturn]] void report_exit(const char* function, int exit_code, const void* caller) noexcept;

/// Ends the process like a crash, from a handler of a signal: if a plugin is at work, after a
/// report that says `what` it did: "did not return". Otherwise with the words `else_say`. Without
/// the stack there is one line, and nothing is written but that: it says that plugins were being
/// loaded when one is, and has been for less than a second.
enum class Stack { shown, left_out };
[[noreturn]] void end_process(const char* what, const char* else_say, int exit_status,
                              Stack stack = Stack::shown);

/// Ends the process when a call of the thread that made this takes too long: a plugin that does not
/// return cannot be stopped in any other way. Looks at calls whose clock was started
/// (Call::start_clock()).
class Watchdog {
 public:
  /// `limit_s`: how long a call may take by itself, s; positive. `exit_status`: of the process.
  /// The report comes from the thread itself, by a signal. From one in which a plugin has blocked
  /// all signals it does not come: it is then ended without a stack trace, one second later.
  /// `what` follows the plugin's name in the report, and lives as long as this.
  Watchdog(double limit_s, int exit_status,
           const char* what = "did not return within its time budget and was stopped");
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

 private:
  void* timer_ = nullptr;
  std::jthread outside_;  // where signals are blocked
};

/// What is known of the plugin at work in this thread, from the innermost call and those around it;
/// nothing is set when none is. For handlers of signals and EmergencyWriters.
plugin::CallFacts facts_at_work() noexcept;

/// The signal of the crash that is being reported; 0: none, as when a plugin calls exit().
int signal_of_crash() noexcept;

}  // namespace elsie::process

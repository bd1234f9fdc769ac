// Functions that end a process, defined before those of the C library: a plugin that calls one ends
// the program, and is named like one that crashes. Plugins find them here because symbols are
// searched for in the program first; CMakeLists.txt exports them.
#include "elsie/process/crash_report.h"

using elsie::process::report_exit;

extern "C" {

__attribute__((noreturn, visibility("default"))) void exit(int exit_code) noexcept {
  report_exit("exit()", exit_code, __builtin_return_address(0));
}

__attribute__((noreturn, visibility("default"))) void _exit(int exit_code) {
  report_exit("_exit()", exit_code, __builtin_return_address(0));
}

__attribute__((noreturn, visibility("default"))) void _Exit(int exit_code) noexcept {
  report_exit("_Exit()", exit_code, __builtin_return_address(0));
}

__attribute__((noreturn, visibility("default"))) void quick_exit(int exit_code) noexcept {
  report_exit("quick_exit()", exit_code, __builtin_return_address(0));
}
}

namespace {

/// errx() and others of the C library call its own exit(), which runs this. The program itself
/// always ends by process::end_with().
__attribute__((destructor)) void leave() { report_exit("exit()", 0, nullptr); }

}  // namespace

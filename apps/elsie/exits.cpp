// Functions that end a process, put before those of the C library: a plugin that calls one ends the
// program, and is named as one that crashes is. Plugins find them here because symbols are looked
// for in the program first; CMakeLists.txt has them exported.
//
// exit() is not among them: it runs what was registered with atexit(), where crash_report.h is.
#include "elsie/process/crash_report.h"

extern "C" {

[[noreturn, gnu::visibility("default")]] void _exit(int exit_code) {
  elsie::process::report_exit("_exit()", exit_code, __builtin_return_address(0));
}

[[noreturn, gnu::visibility("default")]] void _Exit(int exit_code) noexcept {
  elsie::process::report_exit("_Exit()", exit_code, __builtin_return_address(0));
}

[[noreturn, gnu::visibility("default")]] void quick_exit(int exit_code) noexcept {
  elsie::process::report_exit("quick_exit()", exit_code, __builtin_return_address(0));
}
}

// The function that throws an exception, defined before that of the C++ library, so that an
// exception of a plugin is reported with its line: see exits.cpp, and note_throw() in
// crash_report.h.
#include <dlfcn.h>

#include "elsie/process/crash_report.h"

extern "C" {

// A function of the C++ library (Itanium C++ ABI, 2.4.3).
// NOLINTNEXTLINE(bugprone-reserved-identifier, readability-identifier-naming)
__attribute__((noreturn, visibility("default"))) void __cxa_throw(void* exception, void* type,
                                                                  void (*destroy)(void*)) {
  using Throw = void (*)(void*, void*, void (*)(void*));
  static const auto of_library = reinterpret_cast<Throw>(dlsym(RTLD_NEXT, "__cxa_throw"));
  elsie::process::note_throw(exception);
  of_library(exception, type, destroy);
  __builtin_unreachable();
}
}

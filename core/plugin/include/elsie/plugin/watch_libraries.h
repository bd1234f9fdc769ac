// The addresses of plugin libraries in memory, for crash reports.
#pragma once

namespace elsie::plugin {

/// Calls this function for each library that is loaded from now on. `code`: any address in it;
/// `file`: its name in crash reports. A program calls this once, early.
void watch_libraries(void (*loaded)(const void* code, const char* file)) noexcept;

}  // namespace elsie::plugin

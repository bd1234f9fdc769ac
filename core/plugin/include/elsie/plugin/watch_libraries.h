// The addresses of plugin libraries in memory, for crash reports.
#pragma once

namespace elsie::plugin {

/// Called for each library. `file`: its name in crash reports, valid until `unloading`.
struct LibraryWatch {
  void (*loaded)(const void* code, const char* file) noexcept;  // `code`: any address in it
  void (*unloading)(const char* file) noexcept;
};

/// Starts to call these functions. A program calls this once, early.
void watch_libraries(const LibraryWatch& watch) noexcept;

}  // namespace elsie::plugin

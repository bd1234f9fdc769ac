// Where plugin libraries are in memory, for reports of crashes.
#pragma once

namespace elsie::plugin {

/// What is called for each library. `file`: what crash reports name; it lives until `unloading`.
struct LibraryWatch {
  void (*loaded)(const void* code, const char* file) noexcept;  // `code`: any address in it
  void (*unloading)(const char* file) noexcept;
};

/// Calls these from now on. A program calls this once, early.
void watch_libraries(const LibraryWatch& watch) noexcept;

}  // namespace elsie::plugin

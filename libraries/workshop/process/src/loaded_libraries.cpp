#include "loaded_libraries.h"

#include <atomic>
#include <string>

#include <dlfcn.h>

#include "elsie/plugin/watch_libraries.h"

namespace elsie::process {
namespace {

/// A library that was loaded. Never freed: a signal handler reads it at any time, and a thread that
/// a library left behind crashes after it was unloaded.
struct Loaded {
  std::string file;
  const void* begin;
  const void* end;
  const Loaded* before;
};

std::atomic<const Loaded*> newest{nullptr};

void note(const void* code, const char* file) {
  dl_find_object found{};
  if (_dl_find_object(const_cast<void*>(code), &found) == 0) {
    auto* const loaded = new Loaded{file, found.dlfo_map_start, found.dlfo_map_end, newest};
    while (!newest.compare_exchange_weak(loaded->before, loaded)) {
    }
  }
}

}  // namespace

void watch_libraries() noexcept { plugin::watch_libraries(note); }

const char* plugin_library_at(const void* address) noexcept {
  // The newest first: it may be where an older one was.
  for (const Loaded* each = newest; each; each = each->before) {
    if (address >= each->begin && address < each->end) {
      return each->file.c_str();
    }
  }
  return nullptr;
}

}  // namespace elsie::process

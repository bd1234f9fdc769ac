#include "loaded_libraries.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <string>

#include <link.h>

#include "elsie/plugin/watch_libraries.h"

namespace elsie::process {
namespace {

struct Range {
  std::uintptr_t begin = 0;
  std::uintptr_t end = 0;

  bool has(std::uintptr_t address) const { return address >= begin && address < end; }
};

/// A library that was loaded. Never freed: a signal handler reads it at any time, and a thread that
/// a library left behind crashes after it was unloaded.
struct Loaded {
  std::string file;
  Range range;
  const Loaded* before;
};

std::atomic<const Loaded*> last{nullptr};

/// The address range of the library that the code belongs to.
Range range_of(const void* code) noexcept {
  struct Search {
    std::uintptr_t address;
    Range found;
  } search{reinterpret_cast<std::uintptr_t>(code), {}};
  dl_iterate_phdr(
      [](dl_phdr_info* library, std::size_t, void* data) {
        Search& wanted = *static_cast<Search*>(data);
        Range range{~std::uintptr_t{0}, 0};
        for (int i = 0; i < library->dlpi_phnum; ++i) {
          const ElfW(Phdr)& segment = library->dlpi_phdr[i];
          if (segment.p_type == PT_LOAD) {
            const std::uintptr_t begin = library->dlpi_addr + segment.p_vaddr;
            range.begin = std::min(range.begin, begin);
            range.end = std::max(range.end, begin + segment.p_memsz);
          }
        }
        if (!range.has(wanted.address)) {
          return 0;
        }
        wanted.found = range;
        return 1;
      },
      &search);
  return search.found;
}

void note(const void* code, const char* file) noexcept {
  auto* const loaded = new Loaded{file, range_of(code), last};
  while (!last.compare_exchange_weak(loaded->before, loaded)) {
  }
}

}  // namespace

void watch_libraries() noexcept { plugin::watch_libraries(note); }

const char* plugin_library_at(const void* address) noexcept {
  // The newest first: it may be where an older one was.
  for (const Loaded* each = last; each; each = each->before) {
    if (each->range.has(reinterpret_cast<std::uintptr_t>(address))) {
      return each->file.c_str();
    }
  }
  return nullptr;
}

}  // namespace elsie::process

#include "loaded_libraries.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <set>
#include <string>

#include <link.h>

#include "elsie/plugin/watch_libraries.h"

namespace elsie::process {
namespace {

struct Range {
  std::uintptr_t begin = 0;
  std::uintptr_t end = 0;
};

/// A library and its addresses. Signal handlers read it at any time, so the name is set last and
/// cleared first.
struct Slot {
  std::atomic<const char*> file{nullptr};  // a copy, which is never freed
  std::atomic<std::uintptr_t> begin{0};
  std::atomic<std::uintptr_t> end{0};
  std::atomic<bool> is_loaded{false};
};

// Signal handlers can only reach globals. If there are more libraries than slots, later ones are
// not named when their threads crash.
std::array<Slot, 256> slots;

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
        const bool is_it = wanted.address >= range.begin && wanted.address < range.end;
        if (is_it) {
          wanted.found = range;
        }
        return is_it ? 1 : 0;
      },
      &search);
  return search.found;
}

/// A copy that is never freed, because a handler may be reading it; each name once.
const char* kept(const char* file) {
  static std::mutex mutex;
  static auto& names = *new std::set<std::string>;
  const std::lock_guard lock(mutex);
  return names.emplace(file).first->c_str();
}

void note_loaded(const void* code, const char* file) noexcept {
  const Range range = range_of(code);
  for (Slot& slot : slots) {
    const char* const known = slot.file;
    // Reuses slots of libraries that were unloaded from here, or from the same file.
    const bool is_free =
        !known || (!slot.is_loaded && (std::strcmp(known, file) == 0 ||
                                       (slot.begin < range.end && range.begin < slot.end)));
    if (is_free) {
      slot.file = nullptr;
      slot.begin = range.begin;
      slot.end = range.end;
      slot.is_loaded = true;
      slot.file = kept(file);
      return;
    }
  }
}

/// Keeps the addresses of an unloaded library, because a thread that it left behind crashes there.
void note_unloaded(const char* file) noexcept {
  for (Slot& slot : slots) {
    const char* const known = slot.file;
    if (known && slot.is_loaded && std::strcmp(known, file) == 0) {
      slot.is_loaded = false;
      return;
    }
  }
}

}  // namespace

void watch_libraries() noexcept { plugin::watch_libraries({note_loaded, note_unloaded}); }

const char* plugin_library_at(const void* address) noexcept {
  const auto at = reinterpret_cast<std::uintptr_t>(address);
  const char* gone = nullptr;
  for (const Slot& slot : slots) {
    const char* const file = slot.file;
    if (file && at >= slot.begin && at < slot.end) {
      if (slot.is_loaded) {
        return file;
      }
      gone = file;
    }
  }
  return gone;
}

}  // namespace elsie::process

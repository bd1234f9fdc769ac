#include "plugins/guard.h"

#include <algorithm>
#include <cstddef>

#include <malloc.h>

#include "elsie/base/number_text.h"

// A function of the address sanitizer, which has its own allocator; null without it.
// NOLINTNEXTLINE(bugprone-reserved-identifier, readability-identifier-naming)
extern "C" __attribute__((weak)) std::size_t __sanitizer_get_current_allocated_bytes();

namespace elsie::simulation {
namespace {

std::string short_text(double value) { return base::number_text(value, 4); }

/// Memory allocated on the heap of the process, bytes. Takes about a microsecond.
std::int64_t heap_bytes() {
  if (__sanitizer_get_current_allocated_bytes) {
    return static_cast<std::int64_t>(__sanitizer_get_current_allocated_bytes());
  }
  const auto info = mallinfo2();
  return static_cast<std::int64_t>(info.uordblks + info.hblkhd);
}

}  // namespace

void Guard::note_arithmetic(const world::PluginUse& use, const char* changed) {
  const auto known = std::find_if(
      arithmetic_.begin(), arithmetic_.end(),
      [&](const ChangedArithmetic& one) { return one.id == use.id && one.what == changed; });
  ChangedArithmetic& entry = known != arithmetic_.end()
                                 ? *known
                                 : arithmetic_.emplace_back(ChangedArithmetic{
                                       use.id, changed, base::step_text(step_, time_s_), 0});
  ++entry.calls;
}

void Guard::list_notes(std::vector<Note>& notes) const {
  for (const ChangedArithmetic& one : arithmetic_) {
    notes.push_back({robot_, one.id,
                     "changed " + one.what + " for the whole program, " +
                         (one.calls == 1 ? "once" : std::to_string(one.calls) + " times") +
                         ", first in " + one.first + "; this was undone after each call"});
  }
}

std::int64_t Guard::begin(plugin::Call& call) const {
  const std::int64_t before = budget_.memory > 0 ? heap_bytes() : 0;
  if (budget_.time_s > 0.0) {
    call.start_clock();
  }
  return before;
}

void Guard::end(const world::PluginUse& use, Heap& heap, const plugin::Call& call,
                std::int64_t before) {
  const double took_s = call.own_time_s();
  if (budget_.memory > 0) {
    const std::int64_t grown = heap_bytes() - before;
    if (call.outer()) {
      call.outer()->inner_bytes += grown;
    }
    heap.bytes += grown - call.inner_bytes;
    ++heap.calls;
    if (heap.bytes > static_cast<std::int64_t>(budget_.memory)) {
      fail(use, "it holds " + short_text(1e-6 * static_cast<double>(heap.bytes)) +
                    " MB more than when the run began, " +
                    short_text(static_cast<double>(heap.bytes) / static_cast<double>(heap.calls)) +
                    " bytes a call, which is beyond its memory budget of " +
                    short_text(1e-6 * static_cast<double>(budget_.memory)) +
                    " MB; does it free what it allocates?");
    }
  }
  if (budget_.time_s > 0.0 && took_s > budget_.time_s) {
    fail(use, "it took " + short_text(1e3 * took_s) +
                  " ms to answer, which is beyond its time budget of " +
                  short_text(1e3 * budget_.time_s) + " ms");
  }
}

}  // namespace elsie::simulation

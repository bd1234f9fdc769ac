#include "elsie/plugin/call.h"

#include <array>
#include <atomic>

#include <pthread.h>
#include <time.h>

namespace elsie::plugin {
namespace {

std::int64_t now_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

std::atomic<void (*)() noexcept> at_end_of_copy{nullptr};

/// Where each shown thread has its innermost call. Threads beyond this number are not shown.
std::array<std::atomic<Call* const*>, 256> shown;

void replace_shown(Call* const* old, Call* const* now) noexcept {
  for (auto& slot : shown) {
    Call* const* expected = old;
    if (slot.compare_exchange_strong(expected, now)) return;
  }
}

}  // namespace

void (*Call::end_copy_)() noexcept = nullptr;
constinit thread_local Call* Call::innermost_ = nullptr;

void Call::stop_clock() noexcept {
  if (outer_) {
    outer_->inner_ns_ += now_ns() - start_ns_;
  }
}

void Call::watch_for_copies(void (*end_copy)() noexcept) {
  if (at_end_of_copy.exchange(end_copy)) return;
  const auto in_parent = [] {
    if (innermost_) {
      innermost_->has_forked_ = true;
    }
  };
  const auto in_child = [] { end_copy_ = innermost_ ? at_end_of_copy.load() : nullptr; };
  pthread_atfork(nullptr, in_parent, in_child);
}

const char* Call::restore_from(const Arithmetic& now) noexcept {
  before_.restore();
  return now.difference_from(before_);
}

void Call::show_thread() {
  struct Shown {
    Shown() noexcept { replace_shown(nullptr, &innermost_); }
    ~Shown() { replace_shown(&innermost_, nullptr); }
  };
  thread_local const Shown until_it_ends;
}

Call* Call::of_shown_threads() noexcept {
  for (Call* const* const slot : shown) {
    if (slot && *slot) return *slot;
  }
  return nullptr;
}

void Call::start_clock() noexcept { start_ns_ = now_ns(); }

double Call::own_time_s() const noexcept {
  return start_ns_ == 0 ? 0.0 : 1e-9 * static_cast<double>(now_ns() - start_ns_ - inner_ns_);
}

}  // namespace elsie::plugin

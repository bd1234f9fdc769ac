#include "elsie/base/thread_pool.h"

#include <algorithm>
#include <csignal>
#include <memory>
#include <utility>

#include <pthread.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace elsie::base {
namespace {

/// Shares for each thread: few enough to cost nothing, enough that no thread waits long for
/// another.
constexpr std::size_t kSharesPerThread = 8;
/// Looks for work before a thread sleeps: some microseconds, because the next work of a step
/// follows soon.
constexpr int kLooks = 2000;

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

int this_thread() { return static_cast<int>(syscall(SYS_gettid)); }

constinit thread_local int helped = 0;  // 0: this thread works for itself

/// Waits until the value is not `old`, and returns it.
std::uint32_t next_value(const std::atomic<std::uint32_t>& value, std::uint32_t old) {
  for (int i = 0; i < kLooks; ++i) {
    if (const std::uint32_t now = value.load(std::memory_order_acquire); now != old) return now;
    pause();
  }
  value.wait(old, std::memory_order_acquire);
  return value.load(std::memory_order_acquire);
}

}  // namespace

ThreadPool::ThreadPool(std::size_t threads) {
  sigset_t others;
  sigset_t before;
  sigfillset(&others);
  for (const int own : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGTRAP, SIGSYS}) {
    sigdelset(&others, own);
  }
  pthread_sigmask(SIG_SETMASK, &others, &before);
  for (std::size_t i = 1; i < threads; ++i) {
    helpers_.emplace_back([this, i] { help(i); });
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

ThreadPool::~ThreadPool() {
  over_ = true;
  calls_.fetch_add(1, std::memory_order_release);
  calls_.notify_all();
  for (std::thread& helper : helpers_) {
    helper.join();
  }
}

int ThreadPool::worked_for() noexcept { return helped != 0 ? helped : this_thread(); }

void ThreadPool::run(std::size_t items, std::size_t least, const void* work, Call call) {
  work_ = work;
  call_ = call;
  items_ = items;
  share_ = std::max(least, items / (threads() * kSharesPerThread));
  owner_ = worked_for();
  failure_ = nullptr;
  next_.store(0, std::memory_order_relaxed);
  gate_.store(0, std::memory_order_release);
  calls_.fetch_add(1, std::memory_order_release);
  calls_.notify_all();
  take_shares(0);
  // Helpers that are still asleep need not wake up.
  std::uint32_t inside = gate_.fetch_or(kClosed, std::memory_order_acq_rel) | kClosed;
  while (inside != kClosed) inside = next_value(gate_, inside);
  if (failure_) {
    std::rethrow_exception(std::exchange(failure_, nullptr));
  }
}

void ThreadPool::help(std::size_t thread) {
  // For signal handlers, if this thread uses up its own.
  constexpr std::size_t kStackSize = std::size_t{64} * 1024;
  const auto stack = std::make_unique_for_overwrite<char[]>(kStackSize);
  stack_t second{};
  second.ss_sp = stack.get();
  second.ss_size = kStackSize;
  stack_t before{};
  sigaltstack(&second, &before);
  for (std::uint32_t calls = next_value(calls_, 0); !over_; calls = next_value(calls_, calls)) {
    std::uint32_t inside = gate_.load(std::memory_order_relaxed);
    while (!(inside & kClosed) && !gate_.compare_exchange_weak(inside, inside + 1)) {
    }
    if (inside & kClosed) continue;  // the work is done
    helped = owner_;
    take_shares(thread);
    helped = 0;
    if (gate_.fetch_sub(1, std::memory_order_acq_rel) == kClosed + 1) gate_.notify_one();
  }
  sigaltstack(&before, nullptr);  // sanitizers have one of their own in each thread
}

void ThreadPool::take_shares(std::size_t thread) {
  for (;;) {
    const std::size_t first = next_.fetch_add(share_, std::memory_order_relaxed);
    if (first >= items_) return;
    try {
      call_(work_, {first, std::min(items_, first + share_), thread});
    } catch (...) {
      const std::scoped_lock lock(failing_);
      if (!failure_ || first < failed_at_) {
        failure_ = std::current_exception();
        failed_at_ = first;
      }
    }
  }
}

}  // namespace elsie::base

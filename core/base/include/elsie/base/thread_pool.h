// Threads that share the work of a step.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace elsie::base {

/// The thread that owns the pool, and helpers that wait for work. Work must give the same result in
/// any order: which thread does which items differs from call to call.
class ThreadPool {
 public:
  /// Consecutive items, from `first` to the one before `end`, for the thread with this number,
  /// below threads().
  struct Share {
    std::size_t first;
    std::size_t end;
    std::size_t thread;
  };

  /// `threads` counts the owner's thread; it is at least 1. Helpers block all signals except their
  /// own faults, which they handle on a second stack. Throws std::system_error if the system has no
  /// more threads.
  explicit ThreadPool(std::size_t threads = 1);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  std::size_t threads() const { return helpers_.size() + 1; }

  /// The system's id of the thread that this one works for: the pool's owner during its work,
  /// otherwise this thread. Signal handlers may call it.
  static int worked_for() noexcept;

  /// Calls work(Share) for all items, at least `least` in a share, and returns when all is done. If
  /// calls throw, throws the exception of the first items among them; the others are done.
  template <class Work>
  void divide(std::size_t items, std::size_t least, const Work& work) {
    if (helpers_.empty() || items <= least) {
      work(Share{0, items, 0});
      return;
    }
    run(items, least, &work,
        [](const void* some, const Share& share) { (*static_cast<const Work*>(some))(share); });
  }

 private:
  using Call = void (*)(const void* work, const Share& share);

  void run(std::size_t items, std::size_t least, const void* work, Call call);
  void help(std::size_t thread);
  void take_shares(std::size_t thread);

  static constexpr std::uint32_t kClosed = 1u << 31;

  // The present work. Written by the owner before it opens the gate.
  const void* work_ = nullptr;
  Call call_ = nullptr;
  std::size_t items_ = 0;
  std::size_t share_ = 0;
  int owner_ = 0;

  alignas(64) std::atomic<std::uint32_t> calls_{0};  // how often work was given out
  alignas(64) std::atomic<std::size_t> next_{0};     // the first item that nobody has
  // The number of helpers at work, and kClosed once no more may begin.
  alignas(64) std::atomic<std::uint32_t> gate_{kClosed};
  std::atomic<bool> over_{false};

  std::mutex failing_;
  std::exception_ptr failure_;
  std::size_t failed_at_ = 0;

  std::vector<std::thread> helpers_;
};

}  // namespace elsie::base

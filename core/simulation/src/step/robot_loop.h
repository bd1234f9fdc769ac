// Calls of all robots, in one thread or in several.
#pragma once

#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "elsie/base/thread_pool.h"
#include "elsie/plugin/call.h"

#include "robot/robot.h"

namespace elsie::simulation {

/// Robots with a plugin that wants one thread are called by the owner of the pool, in their order.
class RobotLoop {
 public:
  explicit RobotLoop(std::size_t threads) : pool_(threads) {}

  base::ThreadPool& pool() { return pool_; }

  /// Calls work(robot, thread) for each index of `robots`. The work for a robot may change only
  /// that robot. If it throws, all others are done nevertheless, so that their states do not depend
  /// on the number of threads; then throws the exception of the first.
  template <class Work>
  void each(std::span<const std::shared_ptr<Robot>> robots, const Work& work) {
    failed_at_ = kNone;
    const auto shared = [&](const base::ThreadPool::Share& share) {
      plugin::Call::show_thread();
      for (std::size_t i = share.first; i < share.end; ++i) {
        if (pool_.threads() == 1 || robots[i]->may_share_threads()) attempt(i, share.thread, work);
      }
    };
    pool_.divide(robots.size(), kLeast, shared);
    for (std::size_t i = 0; pool_.threads() > 1 && i < robots.size(); ++i) {
      if (!robots[i]->may_share_threads()) attempt(i, 0, work);
    }
    if (failed_at_ != kNone) std::rethrow_exception(std::exchange(failure_, nullptr));
  }

  /// The robot whose exception each() threw last; kNone: there was none.
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::size_t failed_at() const { return failed_at_; }

 private:
  /// Robots in a share; fewer are not worth waking a thread.
  static constexpr std::size_t kLeast = 32;

  template <class Work>
  void attempt(std::size_t robot, std::size_t thread, const Work& work) {
    try {
      work(robot, thread);
    } catch (...) {
      const std::scoped_lock lock(failing_);
      if (robot > failed_at_) return;
      failed_at_ = robot;
      failure_ = std::current_exception();
    }
  }

  base::ThreadPool pool_;
  std::mutex failing_;
  std::exception_ptr failure_;
  std::size_t failed_at_ = kNone;
};

}  // namespace elsie::simulation

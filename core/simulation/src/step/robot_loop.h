// Calls of all robots, in one thread or in several.
#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "elsie/base/crew.h"

#include "step/robot.h"

namespace elsie::simulation {

/// Robots with a plugin that wants one thread are called by the owner of the crew, in their order.
class RobotLoop {
 public:
  explicit RobotLoop(std::size_t threads) : crew_(threads) {}

  base::Crew& crew() { return crew_; }

  /// Calls work(robot, thread) for each index of `robots`. The work for a robot may change only
  /// that robot. If it throws, throws the exception of the first such robot; robots before it are
  /// done, others may be.
  template <class Work>
  void each(std::span<const std::shared_ptr<Robot>> robots, const Work& work) {
    failed_at_ = kNone;
    if (crew_.threads() == 1) {
      for (std::size_t i = 0; i < robots.size(); ++i) {
        attempt(i, 0, work);
      }
      return;
    }
    std::exception_ptr failure;
    const auto shared = [&](const base::Crew::Share& share) {
      for (std::size_t i = share.first; i < share.end; ++i) {
        if (robots[i]->may_share_threads()) attempt(i, share.thread, work);
      }
    };
    try {
      crew_.divide(robots.size(), kLeast, shared);
    } catch (...) {
      failure = std::current_exception();
    }
    for (std::size_t i = 0; i < std::min(robots.size(), failed_at_); ++i) {
      if (!robots[i]->may_share_threads()) attempt(i, 0, work);
    }
    if (failure) std::rethrow_exception(failure);
  }

  /// The robot whose exception each() threw last; kNone: there was none.
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::size_t failed_at() const { return failed_at_; }

 private:
  /// Robots in a share: fewer do not pay for the waking of a thread.
  static constexpr std::size_t kLeast = 8;

  template <class Work>
  void attempt(std::size_t robot, std::size_t thread, const Work& work) {
    try {
      work(robot, thread);
    } catch (...) {
      const std::scoped_lock lock(failing_);
      failed_at_ = std::min(failed_at_, robot);
      throw;
    }
  }

  base::Crew crew_;
  std::mutex failing_;
  std::size_t failed_at_ = kNone;
};

}  // namespace elsie::simulation

// One worker process and its pipes.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include <poll.h>
#include <sys/types.h>

#include "elsie/batch/worker_pool.h"

#include "descriptor.h"

namespace elsie::batch {

class WorkerPool::Worker {
 public:
  using Clock = std::chrono::steady_clock;

  /// Starts it. Throws std::runtime_error.
  Worker(const PoolOptions& options, const Job& job);
  /// Kills it if it is still there.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  std::int64_t run() const { return run_; }
  /// When something is to be done about it if it goes on.
  Clock::time_point due() const { return due_; }
  /// What poll(2) is to look at: kPolled entries.
  static constexpr std::size_t kPolled = 3;
  void list(std::vector<pollfd>& polled) const;
  /// Reads what there is.
  void read(const pollfd* polled);
  /// The wall limit, or the end of the grace, was met.
  void overdue(Clock::time_point now);
  bool has_ended() const { return ended_; }
  /// Of one that has ended.
  RunRecord record();

 private:
  void start(const PoolOptions& options, const Job& job);
  void reap();
  void read_output();
  void read_answer();

  std::int64_t run_;
  double wall_limit_s_;
  double grace_s_;
  Clock::time_point begun_;
  Clock::time_point due_;
  pid_t process_ = -1;
  Descriptor process_end_;  // can be read when the process has ended
  Descriptor output_;
  Descriptor answer_;
  std::string log_;
  bool log_is_cut_ = false;
  std::string answered_;
  bool hangs_ = false;
  bool too_long_ = false;  // the answer
  bool ended_ = false;
  int status_ = 0;  // as wait(2) has it
  double wall_s_ = 0.0;
};

}  // namespace elsie::batch

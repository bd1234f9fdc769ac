// One worker process and its pipes.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <poll.h>
#include <sys/types.h>

#include "elsie/batch/worker_pool.h"

#include "descriptor.h"
#include "run_templates.h"

namespace elsie::batch {

class WorkerPool::Worker {
 public:
  using Clock = std::chrono::steady_clock;

  /// Starts the process: a copy of a template, once that is ready, or the program of a worker. The
  /// options and templates must outlive it. Throws std::runtime_error.
  Worker(const PoolOptions& options, Job job, RunTemplates& originals);
  /// Kills the process if it still runs.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  std::int64_t run() const { return job_.run; }
  /// The time at which to call overdue().
  Clock::time_point due() const { return due_; }
  /// The number of entries for poll(2).
  static constexpr std::size_t kPolled = 3;
  void list(std::vector<pollfd>& polled) const;
  /// Reads what the pipes hold, and starts a process that waits for its original. Throws
  /// std::runtime_error if it cannot be started.
  void read(const pollfd* polled);
  /// Called when the wall limit or the grace period is over. Throws as read().
  void overdue(Clock::time_point now);
  bool has_ended() const { return ended_; }
  /// The record of a worker that has ended.
  RunRecord record();

 private:
  bool is_waiting() const { return original_ && process_ < 0 && !ended_; }
  void set_due(double in_s);
  /// Starts the process as soon as it does not have to wait.
  void proceed();
  /// Does so after the process has ended with its template.
  void begin_again();
  /// Kills the process, if it still runs, and its children. Returns whether its status is known.
  bool reap();
  void read_output();
  void read_answer();

  const PoolOptions& options_;
  const Job job_;
  RunTemplates& originals_;
  std::shared_ptr<RunTemplate> original_;  // of which the process is or will be a copy
  bool has_begun_again_ = false;
  Clock::time_point begun_;
  Clock::time_point due_;
  pid_t process_ = -1;
  Descriptor process_end_;  // readable when the process has ended
  Descriptor output_;
  Descriptor answer_;
  std::string log_;
  bool log_is_cut_ = false;
  std::string answered_;
  bool hangs_ = false;
  bool too_long_ = false;  // the answer is too long
  bool ended_ = false;
  int status_ = 0;  // as from waitpid(2)
  double wall_s_ = 0.0;
};

}  // namespace elsie::batch

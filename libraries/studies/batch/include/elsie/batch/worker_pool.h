// Worker processes: each does one run and ends.
//
// A worker is started with the job on its standard input, and answers with a line of JSON on a pipe
// of its own (kResultDescriptor). What it prints is kept, the last kilobytes of it, for the record
// of a run that does not end well. It may crash, hang, exit or be killed: that is its own run's
// affair. Workers die with the process that started them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <optional>
#include <string>
#include <vector>

#include "elsie/batch/job.h"

namespace elsie::batch {

/// Where a worker writes its answer.
inline constexpr int kResultDescriptor = 3;
/// So much of what a worker prints is kept, bytes.
inline constexpr std::size_t kLogTail = 16 * 1024;

struct PoolOptions {
  std::vector<std::string> command{};  // the program of a worker, with its arguments
  std::size_t workers = 1;
  double wall_limit_s = 600.0;  // for one run
  /// A worker that meets the limit is asked by SIGTERM to say what it is at, and killed after this.
  double grace_s = 2.0;
  /// When this descriptor can be read, workers are killed and run() ends. -1: there is none.
  int stop_descriptor = -1;
};

class WorkerPool {
 public:
  /// The next job; none: there are no more.
  using Next = std::function<std::optional<Job>()>;
  /// What became of a run. What it throws ends the work.
  using Ended = std::function<void(std::int64_t run, RunRecord record)>;
  /// Called about once a second, and after each run.
  using Tick = std::function<void()>;

  explicit WorkerPool(PoolOptions options);
  /// Kills the workers that are still there.
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Does all jobs. False when it was stopped: the runs that were being done are not heard of
  /// again. Throws std::runtime_error with a sentence when no worker can be started.
  bool run(const Next& next, const Ended& ended, const Tick& tick = {});

 private:
  class Worker;

  bool wait(std::vector<std::pair<std::int64_t, RunRecord>>& results);

  PoolOptions options_;
  std::list<Worker> workers_;
};

}  // namespace elsie::batch

// Worker processes: each does one run and ends.
//
// Starting a program, loading libraries and reading a world takes longer than a short run.
// Therefore workers are copies (by fork(2)) of a process that has done so; see run_template.h.
// Runs whose libraries cannot be loaded in this way, for example because one starts a thread while
// it is loaded, have a worker that is a program of its own.
//
// A worker gets its job on standard input, and answers with a line of JSON on its own pipe
// (kResultDescriptor). The last kilobytes of its output are kept for the record of a failed run. If
// a worker crashes, hangs, exits or is killed, only its own run fails. Workers end with the process
// that started them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elsie/batch/job.h"

namespace elsie::batch {

class RunTemplates;

/// The descriptor to which a worker writes its answer.
inline constexpr int kResultDescriptor = 3;
/// The number of bytes kept of a worker's output.
inline constexpr std::size_t kLogTail = 16'384;

struct PoolOptions {
  /// The worker's program and its arguments. It ignores SIGTERM, which schedulers send to all
  /// processes of a task: the pool ends its workers.
  std::vector<std::string> command{};
  /// The same for the process of which workers are copies; empty: each is a program of its own.
  std::vector<std::string> template_command{};
  std::size_t workers = 1;
  double wall_limit_s = 600.0;  // of one run
  /// After the wall limit a worker gets SIGXCPU, and after this time SIGKILL.
  double grace_s = 2.0;
  /// When this descriptor becomes readable, workers are killed and run() returns. -1: none.
  int stop_descriptor = -1;
  /// Gets a sentence when the workers of some runs cannot be copies. Empty: no notes.
  std::function<void(const std::string&)> note{};
};

class WorkerPool {
 public:
  /// Returns the next job; none if there are no more.
  using Next = std::function<std::optional<Job>()>;
  /// Gets the result of each run. run() passes on its exceptions.
  using Ended = std::function<void(std::int64_t run, RunRecord record)>;
  /// Called about once a second and after each run.
  using Tick = std::function<void()>;

  explicit WorkerPool(PoolOptions options);
  /// Kills the remaining workers.
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Does all jobs. Returns false if it was stopped; runs that were active then are not reported.
  /// Throws std::runtime_error with a sentence if no worker can be started.
  bool run(const Next& next, const Ended& ended, const Tick& tick = {});

 private:
  class Worker;

  bool wait(std::vector<std::pair<std::int64_t, RunRecord>>& results);

  PoolOptions options_;
  std::unique_ptr<RunTemplates> templates_;
  std::list<Worker> workers_;
};

}  // namespace elsie::batch

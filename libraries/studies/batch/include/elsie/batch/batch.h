// Carries out a plan: worker processes do the runs, this process writes the database.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "elsie/batch/plan.h"
#include "elsie/batch/results_database.h"

namespace elsie::batch {

struct BatchOptions {
  std::vector<std::string> worker{};  // the worker's program and its arguments
  /// See PoolOptions::template_command.
  std::vector<std::string> worker_template{};
  std::size_t workers = 1;
  std::size_t threads = 1;   // of each run; see simulation::Options::threads
  int stop_descriptor = -1;  // the batch stops cleanly when this becomes readable
  std::function<void(const std::string&)> note{};  // see PoolOptions::note
};

/// The progress of the batch.
struct Progress {
  std::int64_t runs = 0;    // runs that were pending when the batch began
  std::int64_t ended = 0;   // those of them that have ended
  std::int64_t failed = 0;  // those that ended in a state other than "done"
  double elapsed_s = 0.0;
  std::optional<double> left_s{};  // estimate of the remaining time; none: not known yet
};

/// A file that a run uses has changed since the batch began; what() is a sentence.
class FileChanged : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Does all pending runs of a database that has a plan, each in its own process, in the order of
/// in_order(). Calls `watch` after each run and
/// about once a second. Returns false if the batch was stopped; runs that were active then stay
/// pending. Throws FileChanged, DatabaseError, and std::runtime_error if no worker can be started;
/// results written before stay valid.
bool carry_out(ResultsDatabase& database, const BatchOptions& options,
               const std::function<void(const Progress&)>& watch = {});

/// Returns the job for a run of the plan.
Job job_of(const Plan& plan, const PlannedRun& run);

}  // namespace elsie::batch

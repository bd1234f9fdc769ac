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
#include "elsie/batch/worker_pool.h"

namespace elsie::batch {

/// The progress of the batch.
struct Progress {
  std::int64_t runs = 0;    // runs that were pending when the batch began
  std::int64_t ended = 0;   // those of them that have ended
  std::int64_t failed = 0;  // those that ended in a state other than "done"
  double elapsed_s = 0.0;

  /// The remaining time, if the other runs take as long on average as those that have ended; all
  /// cells take their turns. None before the first has ended, and after the last.
  std::optional<double> left_s() const {
    return ended > 0 && ended < runs ? std::optional(elapsed_s * static_cast<double>(runs - ended) /
                                                     static_cast<double>(ended))
                                     : std::nullopt;
  }
};

/// A file that a run uses has changed since the batch began; what() is a sentence.
class FileChanged : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Does all pending runs of a database that has a plan, each in its own process, in the order of
/// in_order(). `options`: the wall limit is that of the plan. `threads` of each run: see
/// simulation::Options. Calls `watch` after each run and about once a second. Returns false if the
/// batch was stopped; runs that were active then stay pending. Throws FileChanged, DatabaseError,
/// and std::runtime_error if no worker can be started; results written before stay valid.
bool carry_out(ResultsDatabase& database, PoolOptions options, std::size_t threads,
               const std::function<void(const Progress&)>& watch = {});

/// Returns the job for a run of the plan.
Job job_of(const Plan& plan, const PlannedRun& run);

}  // namespace elsie::batch

// A plan carried out: worker processes on one side, the database on the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "elsie/batch/plan.h"
#include "elsie/batch/results_database.h"

namespace elsie::batch {

struct BatchOptions {
  std::vector<std::string> worker{};  // the program of a worker with its arguments
  std::size_t workers = 1;
  int stop_descriptor = -1;  // when it can be read, the batch stops in order
};

/// How far it is.
struct Progress {
  std::int64_t runs = 0;    // that were to be done when the batch began
  std::int64_t ended = 0;   // of these
  std::int64_t failed = 0;  // of these, other than done
  double elapsed_s = 0.0;

  /// What the runs so far say of the rest, s; negative: nothing yet.
  double left_s() const {
    return ended > 0 ? elapsed_s / static_cast<double>(ended) * static_cast<double>(runs - ended)
                     : -1.0;
  }
};

/// A file that a run uses is no longer what it was when the batch began; what() is a sentence.
class FileChanged : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Does all runs of the plan that are pending in the database, each in a process of its own.
/// `watch` is called after each run and about once a second. False when it was stopped: runs that
/// were at work stay pending. Throws FileChanged, DatabaseError, and std::runtime_error when no
/// worker can be started; what was written until then is valid.
bool carry_out(const Plan& plan, ResultsDatabase& database, const BatchOptions& options,
               const std::function<void(const Progress&)>& watch = {});

/// The job of a run of the plan.
Job job_of(const Plan& plan, const PlannedRun& run);

}  // namespace elsie::batch

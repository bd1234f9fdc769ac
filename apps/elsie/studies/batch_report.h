// The output of `elsie batch` during its work and at the end.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "elsie/batch/batch.h"

#include "status_line.h"

namespace elsie::program {

class BatchReport {
 public:
  /// Plan and database must stay in place. `resume`: the command line that resumes the batch.
  BatchReport(const batch::Plan& plan, batch::ResultsDatabase& database, std::string resume);

  /// Called when there is nothing to do.
  void all_done_already() { done_already_ = true; }
  /// Called when the runs begin; `bar`: show their progress on standard error.
  void begin(bool bar);
  void progress(const batch::Progress& progress);
  /// Called when all runs have ended, or the batch was stopped; removes the bar.
  void end(bool interrupted);

  bool interrupted() const { return interrupted_; }
  /// A table with a row for each cell, the failed runs, and the command to replay one.
  std::string table();
  /// One JSON object on one line; docs/running-many.md lists its members.
  std::string json();
  /// A sentence with the command that resumes the batch.
  std::string interruption();
  int exit_code();

 private:
  /// The labels of cells whose worlds have no goals.
  std::set<std::string> without_goals() const;

  /// "5 of 20 seeds complete": how much of a batch that was stopped is a study of its own.
  std::string complete_seeds();

  const batch::Plan& plan_;
  batch::ResultsDatabase& database_;
  std::string resume_;
  bool done_already_ = false;
  std::optional<StatusLine> bar_;
  bool interrupted_ = false;
  batch::Progress last_;
};

/// A bar, the number of ended runs, and the estimated remaining time.
std::string progress_line(const batch::Progress& progress);

/// "1 h 5 min", "2 min 10 s", "8 s".
std::string duration_text(double seconds);

}  // namespace elsie::program

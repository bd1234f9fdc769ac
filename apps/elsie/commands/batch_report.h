// What `elsie batch` tells: while it is at work, and in the end.
#pragma once

#include <set>
#include <string>

#include "elsie/batch/batch.h"

namespace elsie::program {

class BatchReport {
 public:
  /// Both must stay where they are. `resume`: the command line that goes on with the database.
  BatchReport(const batch::Plan& plan, batch::ResultsDatabase& database, std::string resume);

  /// There was nothing to do.
  void all_done_already() { done_already_ = true; }
  /// The runs begin; `bar`: show how far they are, on standard error.
  void begin(bool bar);
  void progress(const batch::Progress& progress);
  /// The runs have ended, all of them or not; the bar is wiped.
  void end(bool interrupted);

  bool interrupted() const { return interrupted_; }
  /// A table with a row for each cell, what failed, and how to look at it.
  std::string table();
  /// One JSON object on one line; docs/running-many.md tells its members.
  std::string json();
  /// A sentence with the command that goes on.
  std::string interruption();
  int exit_code();

 private:
  /// The labels of the cells whose worlds have none.
  std::set<std::string> without_goals() const;

  const batch::Plan& plan_;
  batch::ResultsDatabase& database_;
  std::string resume_;
  bool done_already_ = false;
  bool bar_ = false;
  bool interrupted_ = false;
  batch::Progress last_;
};

/// A bar, how many runs have ended, how long the rest will take.
std::string progress_line(const batch::Progress& progress);

/// "1 h 5 min", "2 min 10 s", "8 s".
std::string duration_text(double seconds);

}  // namespace elsie::program

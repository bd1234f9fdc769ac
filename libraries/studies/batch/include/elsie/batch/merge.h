// Merges several databases of one experiment.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace elsie::batch {

struct Merged {
  std::int64_t all_runs = 0;    // runs of the experiment
  std::int64_t pending = 0;     // runs in the databases that are not done yet
  std::int64_t missing = 0;     // runs that are in none of the databases
  std::int64_t duplicates = 0;  // runs that ended in several databases; each counts once
};

/// Writes a new database with the runs of all given ones. `elsie batch --resume` then does the
/// pending and the missing runs. The order of the given databases does not matter.
///
/// Some may have been extended, and others not yet: the new one has the larger experiment.
///
/// When several databases have a run, "done" wins over "fault", then "crash", "hang", "error", and
/// "pending": a failure may be due to one machine. Of two runs that failed in the same way, or are
/// done with equal results, one is kept.
///
/// Throws DatabaseRefused, and leaves no file behind, if the new file already exists; if a given
/// database is named twice, is not a results database, is damaged, is being written, or belongs to
/// another experiment than the first; or if a run is done in two of them with different outcomes or
/// state hashes. Throws DatabaseError if the new file cannot be written.
Merged merge(const std::filesystem::path& into,
             const std::vector<std::filesystem::path>& databases);

}  // namespace elsie::batch

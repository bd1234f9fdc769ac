// Several databases of one experiment as one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace elsie::batch {

struct Merged {
  std::int64_t all_runs = 0;    // of the experiment
  std::int64_t pending = 0;     // that are in the databases, but still to be done
  std::int64_t missing = 0;     // that are in none of them
  std::int64_t duplicates = 0;  // that had ended in more than one of them, and count once
};

/// Writes a new database with the runs of all those given. `elsie batch --resume` goes on with it:
/// it does what is pending or missing. The order of the given ones does not matter.
///
/// Of a run that is in several of them, "done" counts before "fault", then "crash", "hang",
/// "error", and "pending" last: what failed on one machine may have failed for its sake. Of two
/// that failed in the same way, or are done and the same, one counts.
///
/// Throws DatabaseRefused, and leaves nothing behind, when the new file is there already, one of
/// the given is named twice, is no results database or a damaged one, is being written, is of
/// another experiment than the first, or when a run is done in two of them with different outcomes
/// or state hashes. DatabaseError when the new one cannot be written.
Merged merge(const std::filesystem::path& into,
             const std::vector<std::filesystem::path>& databases);

}  // namespace elsie::batch

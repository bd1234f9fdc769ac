// Experiments that grow: which runs came when, and so which numbers they have.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "elsie/batch/plan.h"
#include "elsie/results/sqlite.h"

namespace elsie::batch {

namespace sqlite = results::sqlite;

/// Gives each run of the plan its number, and each stage its number of runs: first all runs of the
/// first stage in the order of cells, seeds, repetitions; then those of the second that are not in
/// the first, in the same order... Keeps those of the shard.
void number_runs(Plan& plan);

/// SHA-256 over everything that affects the results of the first `stages` stages.
std::string fingerprint_of(const Plan& plan, std::size_t stages);

/// What a database has of an experiment.
struct StoredGrid {
  struct Cell {
    std::vector<std::string> levels;  // labels, in the order of the factors
    std::string label;
    std::string sha256;  // of its world's text
  };
  std::vector<std::string> factors;
  std::vector<Cell> cells;  // by id
  std::vector<Stage> stages;
};
/// Throws results::DatabaseRefused if its stages cannot be those of an experiment.
StoredGrid stored_grid(sqlite::Connection& connection, const std::filesystem::path& file);

/// What a plan lacks that the database has. Texts name each.
struct Gone {
  std::vector<std::string> cells;  // labels
  std::vector<std::uint64_t> seeds;
  int repeats = 0;  // of each run, if they are fewer now

  bool any() const { return !cells.empty() || !seeds.empty() || repeats > 0; }
};
Gone gone_from(const StoredGrid& stored, const Plan& plan);

/// The plan with the numbers of the database: cells in its order, new ones last, and one stage more
/// if the plan has more cells, seeds or repetitions. Nothing may be gone.
Plan continued(const StoredGrid& stored, Plan plan);

/// Seeds as "1-20,33", and back; none for a text that is no such list, or one of more seeds than an
/// experiment may have.
std::string seeds_text(const std::vector<std::uint64_t>& seeds);
std::optional<std::vector<std::uint64_t>> seeds_in(const std::string& text);

}  // namespace elsie::batch

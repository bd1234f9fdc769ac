// The options of `elsie batch`, and the plan and database that they name.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "elsie/batch/plan.h"

#include "environment.h"

namespace elsie::program {

struct BatchOptions {
  PluginOptions plugins;
  std::string experiment;
  std::optional<std::size_t> workers;
  std::size_t threads = 1;
  std::optional<std::string> database;
  bool resume = false;
  bool again = false;
  bool extend = false;
  std::string shard = "1/1";
  std::optional<std::string> progress;
  std::optional<std::string> cluster;
  std::optional<std::size_t> shards;
  std::vector<std::string> sbatch;
  bool detach = false;
  bool fresh_processes = false;
  bool json = false;
  bool quiet = false;
};

/// The number of processors that this process may use.
std::size_t processors();

/// Throws BadInput if the text is not a shard.
batch::Shard shard_of(const BatchOptions& options);

/// The path of the database.
std::filesystem::path database_of(const BatchOptions& options, const batch::Shard& shard);

/// Reads the experiment with its plugins, and everything that its runs need.
batch::Plan plan_of(const BatchOptions& options, const batch::Shard& shard);

/// The command line that resumes a batch.
std::string resume_command(const BatchOptions& options, const std::filesystem::path& database);

/// Runs the batch as a job array of a cluster and follows it to its end; returns the exit code.
int run_on_cluster(const BatchOptions& options);

}  // namespace elsie::program

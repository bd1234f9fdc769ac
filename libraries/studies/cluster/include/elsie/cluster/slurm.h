// Slurm through its commands: sbatch, squeue, scontrol. A batch is a job array whose tasks have the
// numbers of the shards. https://slurm.schedmd.com/job_array.html
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace elsie::cluster {

/// The cluster refused the work, or there is none; what() is a sentence. Nothing was submitted.
class ClusterRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The cluster does not answer now; what() is a sentence. Submitted work may continue.
class ClusterSilent : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct ArrayRequest {
  std::string name;
  std::filesystem::path script;
  std::vector<std::size_t> tasks;      // from 1, ascending
  std::size_t processors = 1;          // of each task
  std::filesystem::path log;           // "%a" stands for a task's number
  std::vector<std::string> options{};  // further ones for sbatch, which take precedence
};

/// A task that has not ended.
struct Task {
  std::size_t number = 0;
  bool running = false;  // false: it waits
  std::string reason;    // why it waits, in Slurm's words: "Resources"
};

/// Submits the array; returns its job number. Throws ClusterRefused.
std::string submit(const ArrayRequest& request);

/// The user's unfinished tasks of arrays of this name. Throws ClusterSilent, and ClusterRefused
/// when there is no program squeue.
std::vector<Task> unfinished(const std::string& name);

/// How a task has ended, in Slurm's words: "CANCELLED, exit code 0:15". Empty when Slurm has
/// forgotten it.
std::string fate(const std::string& job, std::size_t task);

/// "1-3,7", as sbatch takes them.
std::string ranges(const std::vector<std::size_t>& numbers);

}  // namespace elsie::cluster

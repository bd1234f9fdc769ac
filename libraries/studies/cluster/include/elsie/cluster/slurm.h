// Slurm through its commands: sbatch, squeue, scontrol. A batch is a job array whose tasks have the
// numbers of the shards. https://slurm.schedmd.com/job_array.html
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace elsie::cluster {

/// The cluster refused the tasks, or none was found; what() is a sentence. Nothing was submitted.
class ClusterRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The cluster does not answer now; what() is a sentence. Submitted tasks may continue.
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
  std::vector<std::string> options{};  // further options of sbatch, which take precedence
};

/// A task that has not ended.
struct Task {
  std::size_t number = 0;
  bool running = false;  // false if it waits
  std::string reason;    // why it waits, in Slurm's words: "Resources"
};

/// Submits the array; returns its job number. Throws ClusterRefused.
std::string submit(const ArrayRequest& request);

/// Returns the user's unfinished tasks of arrays of this name. Throws ClusterSilent, or
/// ClusterRefused if there is no program squeue.
std::vector<Task> unfinished(const std::string& name);

/// Returns how a task has ended, in Slurm's words: "CANCELLED, exit code 0:15". Empty if Slurm no
/// longer knows the task.
std::string fate(const std::string& job, std::size_t task);

/// Returns numbers in the form that sbatch takes: "1-3,7".
std::string ranges(const std::vector<std::size_t>& numbers);

}  // namespace elsie::cluster

// Slurm by its commands: sbatch, squeue, scontrol. What it counts with is a job array, whose tasks
// are numbered as the shards of an experiment are. https://slurm.schedmd.com/job_array.html
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace elsie::cluster {

/// The cluster did not take the work, or there is none; what() is a sentence. Nothing was begun.
class ClusterRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The cluster does not answer now; what() is a sentence. What was begun may go on.
class ClusterSilent : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct ArrayRequest {
  std::string name;
  std::filesystem::path script;
  std::vector<std::size_t> tasks;      // numbers, from 1, ascending
  std::size_t processors = 1;          // for each task
  std::filesystem::path log;           // %a in it is a task's number
  std::vector<std::string> options{};  // further ones of sbatch; they take precedence
};

/// A task that has not ended.
struct Task {
  std::size_t number = 0;
  bool running = false;  // otherwise it waits
  std::string reason;    // why it waits, a word of Slurm's: "Resources"
};

/// Hands the array to Slurm; returns its job number. Throws ClusterRefused.
std::string submit(const ArrayRequest& request);

/// The user's tasks of arrays of this name that have not ended. Throws ClusterSilent, and
/// ClusterRefused when there is no such program as squeue.
std::vector<Task> unfinished(const std::string& name);

/// What became of a task that has ended, in Slurm's words: "CANCELLED, exit code 0:15". Empty when
/// Slurm has forgotten it.
std::string fate(const std::string& job, std::size_t task);

/// "1-3,7": as sbatch takes them.
std::string ranges(const std::vector<std::size_t>& numbers);

}  // namespace elsie::cluster

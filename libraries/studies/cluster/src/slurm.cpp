#include "elsie/cluster/slurm.h"

#include <charconv>
#include <sstream>
#include <string_view>

#include "elsie/files/clean_text.h"
#include "elsie/process/run_process.h"

namespace elsie::cluster {
namespace {

/// The end of a command's output, on one line.
std::string end_of(std::string_view output) {
  return files::one_line(output.substr(0, output.find_last_not_of('\n') + 1));
}

process::ProcessResult answer_of(const std::vector<std::string>& command) {
  // posix_spawnp() may report a missing program in this way.
  const auto result = process::run_process(command);
  if (!result || result->exit_code == 127) {
    throw ClusterRefused("there is no program '" + command.front() +
                         "' here; is this a machine that submits jobs to Slurm?");
  }
  return *result;
}

/// The value after `key` in scontrol's output: "JobId=17 JobState=FAILED Reason=..."
std::string value_of(const std::string& text, std::string_view key) {
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (word.size() > key.size() && word.compare(0, key.size(), key) == 0 &&
        word[key.size()] == '=') {
      return word.substr(key.size() + 1);
    }
  }
  return "";
}

}  // namespace

std::string ranges(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t end = i;
    while (end + 1 < numbers.size() && numbers[end + 1] == numbers[end] + 1) {
      ++end;
    }
    text += (text.empty() ? "" : ",") + std::to_string(numbers[i]);
    if (end > i) {
      text += "-" + std::to_string(numbers[end]);
    }
    i = end + 1;
  }
  return text;
}

std::string submit(const ArrayRequest& request) {
  std::vector<std::string> command{"sbatch",
                                   "--parsable",
                                   "--array=" + ranges(request.tasks),
                                   "--job-name=" + request.name,
                                   "--ntasks=1",
                                   "--cpus-per-task=" + std::to_string(request.processors),
                                   "--output=" + request.log.string(),
                                   "--open-mode=append",
                                   "--requeue"};
  command.insert(command.end(), request.options.begin(), request.options.end());
  command.push_back(request.script.string());
  const process::ProcessResult result = answer_of(command);
  // The last line, because sbatch may warn before it: "17" or "17;cluster".
  std::string output = result.output;
  while (!output.empty() && output.back() == '\n') {
    output.pop_back();
  }
  const std::string last = output.substr(output.rfind('\n') + 1);
  const std::string job = last.substr(0, last.find(';'));
  if (result.exit_code != 0 || job.empty() ||
      job.find_first_not_of("0123456789") != std::string::npos) {
    throw ClusterRefused("Slurm does not take the job array: " + end_of(result.output));
  }
  return job;
}

std::vector<Task> unfinished(const std::string& name) {
  const process::ProcessResult result =
      answer_of({"squeue", "--me", "--noheader", "--array", "--name=" + name, "--format=%K|%t|%r"});
  if (result.exit_code != 0) {
    throw ClusterSilent("Slurm does not answer: " + end_of(result.output));
  }
  std::vector<Task> tasks;
  std::istringstream lines(result.output);
  for (std::string line; std::getline(lines, line);) {
    Task task;
    const std::size_t first = line.find('|');
    const std::size_t second = line.find('|', first + 1);
    if (second == std::string::npos ||
        std::from_chars(line.data(), line.data() + first, task.number).ptr != line.data() + first) {
      throw ClusterSilent("the output of squeue is not a task of a job array: " +
                          files::one_line(line));
    }
    const std::string state = line.substr(first + 1, second - first - 1);
    task.running = state == "R" || state == "CG";
    task.reason = line.substr(second + 1);
    tasks.push_back(task);
  }
  return tasks;
}

std::string fate(const std::string& job, std::size_t task) {
  const auto result = process::run_process(
      {"scontrol", "show", "job", "--oneliner", job + "_" + std::to_string(task)});
  if (!result || result->exit_code != 0) {
    return "";
  }
  const std::string state = value_of(result->output, "JobState");
  const std::string code = value_of(result->output, "ExitCode");
  return state.empty() ? "" : state + (code.empty() ? "" : ", exit code " + code);
}

}  // namespace elsie::cluster

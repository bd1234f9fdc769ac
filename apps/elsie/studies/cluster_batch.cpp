// A batch as a job array of Slurm: submitting, following and resuming it, and merging its
// databases.
#include <algorithm>
#include <chrono>
#include <iterator>
#include <optional>
#include <ostream>
#include <utility>

#include <poll.h>
#include <spdlog/spdlog.h>

#include "elsie/base/words.h"
#include "elsie/batch/results_database.h"
#include "elsie/cluster/shard_folder.h"
#include "elsie/cluster/slurm.h"

#include "batch_options.h"
#include "batch_report.h"
#include "command.h"
#include "interrupts.h"
#include "status_line.h"
#include "streams.h"

namespace elsie::program {

namespace fs = std::filesystem;
using batch::Plan;
using batch::ResultsDatabase;
using cluster::ShardFolder;
using cluster::Task;

namespace {

constexpr std::size_t kDefaultShards = 16;
// The scheduler is shared with others, so it is queried often only at the beginning.
constexpr double kFirstPause_s = 0.5;
constexpr double kLongestPause_s = 15.0;
constexpr double kPauseGrowth = 1.2;
// A scheduler may be unavailable for this long, because it restarts or the network is down.
constexpr double kSilenceLimit_s = 600.0;

void require_sound(const BatchOptions& options) {
  if (options.shard != "1/1") {
    throw BadInput(
        "--shard is one part of an experiment, and --cluster does all of them; expected "
        "one of the two");
  }
  if (options.extend) {
    throw BadInput(
        "--extend does not go with --cluster; extend the database that was merged from the shards "
        "without --cluster");
  }
  if (options.again) {
    throw BadInput(
        "--again does not go with --cluster; do the runs that failed again, without "
        "--cluster, in the database that was made of all");
  }
  if (options.progress) {
    throw BadInput("--progress is for a part of an experiment; it does not go with --cluster");
  }
  if (options.detach && options.json) {
    throw BadInput(
        "--json reports how the runs ended, and --detach does not wait for that; expected "
        "one of the two");
  }
}

/// The command of each task, without its shard.
std::vector<std::string> task_command(const BatchOptions& options) {
  const auto absolute = [](const std::string& name) {
    return fs::absolute(name).lexically_normal().string();
  };
  const fs::path program = program_path();
  if (!fs::exists(program)) {
    throw BadInput("this program was replaced by another one while it runs; begin again");
  }
  std::vector<std::string> command{program.string(), "batch", absolute(options.experiment)};
  for (const std::string& directory : options.plugins.directories) {
    command.insert(command.end(), {"--plugin-path", absolute(directory)});
  }
  for (const std::string& file : options.plugins.files) {
    command.insert(command.end(), {"--plugin", absolute(file)});
  }
  command.insert(command.end(), {"--workers", std::to_string(options.workers.value_or(1))});
  if (options.threads > 1) {
    command.insert(command.end(), {"--threads", std::to_string(options.threads)});
  }
  return command;
}

std::vector<std::size_t> numbers(const std::vector<Task>& tasks) {
  std::vector<std::size_t> found;
  for (const Task& task : tasks) {
    found.push_back(task.number);
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// A batch on the cluster, from the folder of its shards to one database.
class ClusterBatch {
 public:
  ClusterBatch(const BatchOptions& options, fs::path file, const Plan& plan, ShardFolder folder)
      : options_(options),
        file_(std::move(file)),
        plan_(plan),
        folder_(std::move(folder)),
        bar_(!options.quiet && !options.json) {}

  /// Submits the shards with pending runs that no task has.
  void submit() {
    const ShardFolder::Turn turn(folder_);
    if (!folder_.exists()) {
      return;  // another command that follows it has merged the databases
    }
    const std::vector<Task> at_work = cluster::unfinished(folder_.name());
    const std::vector<std::size_t> to_do = folder_.unfinished(numbers(at_work));
    if (to_do.empty()) {
      if (!at_work.empty()) {
        say("job array " + folder_.job() + " is at work: " + base::counted(at_work.size(), "task"));
      }
      return;
    }
    asked_ = true;
    folder_.set_job(cluster::submit({.name = folder_.name(),
                                     .script = folder_.script(),
                                     .tasks = to_do,
                                     .processors = options_.workers.value_or(1) * options_.threads,
                                     .log = folder_.log("%a"),
                                     .options = options_.sbatch}));
    say("job array " + folder_.job() + ": " + std::to_string(to_do.size()) + " of " +
        base::counted(static_cast<std::int64_t>(folder_.shards()), "shard") + ", " +
        base::counted(plan_.all_runs, "run") + " in all");
  }

  /// True if submit() failed and certainly left no task behind.
  bool nothing_begun() const {
    if (!asked_) {
      return true;
    }
    try {
      return cluster::unfinished(folder_.name()).empty();
    } catch (const std::exception&) {
      return false;
    }
  }

  /// True if submit() has asked Slurm to take tasks.
  bool has_asked() const { return asked_; }

  /// Waits until no task is left. False if this command was stopped first; the tasks continue.
  bool follow() {
    using Clock = std::chrono::steady_clock;
    const InterruptGuard interrupt;
    const auto begun = Clock::now();
    const std::int64_t ended_before = folder_.count().ended;
    auto answered = begun;
    double pause = kFirstPause_s;
    for (;;) {
      std::optional<std::vector<Task>> tasks;
      try {
        tasks = cluster::unfinished(folder_.name());
        answered = Clock::now();
      } catch (const cluster::ClusterSilent&) {
        if (std::chrono::duration<double>(Clock::now() - answered).count() > kSilenceLimit_s) {
          wipe_status();
          throw;
        }
      }
      elapsed_s_ = std::chrono::duration<double>(Clock::now() - begun).count();
      if (tasks && tasks->empty()) {
        wipe_status();
        return true;
      }
      show(tasks, ended_before);
      pollfd stop{.fd = interrupt.descriptor(), .events = POLLIN, .revents = 0};
      if (poll(&stop, 1, static_cast<int>(1000.0 * pause)) > 0) {
        wipe_status();
        return false;
      }
      pause = std::min(kLongestPause_s, pause * kPauseGrowth);
    }
  }

  /// The message when this command leaves before the tasks end.
  std::string goes_on() const {
    return "job array " + folder_.job() + " continues; follow it with\n  " +
           resume_command(options_, file_) +
           "\nand end it with\n  scancel --name=" + folder_.name() + '\n';
  }

  /// The unfinished shards with reasons; empty: none.
  std::string left_over() const {
    std::string text;
    for (const std::size_t shard : folder_.unfinished()) {
      text += "  shard " + std::to_string(shard) + ": " + std::to_string(folder_.pending(shard)) +
              " of " + base::counted(folder_.runs(shard), "run is", "runs are") +
              " still to be done";
      if (const std::string fate = cluster::fate(folder_.job(), shard); !fate.empty()) {
        text += "; " + fate;
      }
      text += "; see " + folder_.log(std::to_string(shard)).string() + '\n';
    }
    return text;
  }

  /// Merges the databases and reports the results.
  int conclude() {
    folder_.merge_into(file_);
    folder_.remove();
    ResultsDatabase database = ResultsDatabase::open(file_);
    BatchReport report(plan_, database, resume_command(options_, file_));
    report.progress({.runs = plan_.all_runs, .ended = plan_.all_runs, .elapsed_s = elapsed_s_});
    return print(report);
  }

  int print(BatchReport& report) const {
    if (options_.json) {
      data_out() << report.json();
    } else if (!options_.quiet) {
      out() << report.table();
    }
    return report.exit_code();
  }

 private:
  void say(const std::string& line) const {
    if (!options_.quiet && !options_.json) {
      out() << line << '\n' << std::flush;
    }
  }

  void show(const std::optional<std::vector<Task>>& tasks, std::int64_t ended_before) {
    if (!bar_.is_shown()) {
      return;
    }
    std::string note = ", Slurm does not answer";
    if (tasks) {
      const auto running = std::count_if(tasks->begin(), tasks->end(),
                                         [](const Task& task) { return task.running; });
      const auto waits = std::find_if(tasks->begin(), tasks->end(),
                                      [](const Task& task) { return !task.running; });
      note = ", " + base::counted(running, "task") + (running == 1 ? " runs" : " run");
      if (waits != tasks->end()) {
        note += ", " + std::to_string(std::ssize(*tasks) - running) +
                (std::ssize(*tasks) - running == 1 ? " waits (" : " wait (") + waits->reason + ")";
      }
    }
    const cluster::Count count = folder_.count();
    bar_.draw(progress_line({.runs = count.runs - ended_before,
                             .ended = count.ended - ended_before,
                             .failed = count.failed,
                             .elapsed_s = elapsed_s_}) +
              note);
  }

  const BatchOptions& options_;
  const fs::path file_;
  const Plan& plan_;
  ShardFolder folder_;
  StatusLine bar_;
  bool asked_ = false;  // Slurm was asked to take tasks
  double elapsed_s_ = 0.0;
};

ShardFolder make_folder(const BatchOptions& options, const fs::path& file, const Plan& plan) {
  const auto runs = static_cast<std::size_t>(plan.all_runs);
  const std::size_t shards = std::min(options.shards.value_or(kDefaultShards), runs);
  return ShardFolder::create(file, plan, shards, task_command(options));
}

void require_same_shards(const BatchOptions& options, const ShardFolder& folder) {
  if (options.shards && *options.shards != folder.shards()) {
    throw BadInput("--shards: the batch was begun with " + std::to_string(folder.shards()) +
                   " shards, not " + std::to_string(*options.shards));
  }
}

/// True if the databases of the shards were merged. Waits for another command that merges them.
bool is_merged(const fs::path& file, const std::optional<ShardFolder>& folder) {
  std::optional<ShardFolder::Turn> turn;
  if (folder) {
    turn.emplace(*folder);
  }
  return !results::is_vacant(file);
}

/// Handles a batch whose databases were already merged; a killed command may have left its folder.
int already_there(const BatchOptions& options, const fs::path& file, const Plan& plan) {
  ResultsDatabase database = ResultsDatabase::resume(file, plan);
  if (!database.pending().empty()) {
    throw BadInput("'" + file.string() +
                   "' has runs to be done, and is of no cluster; continue it without --cluster");
  }
  if (const auto left = ShardFolder::find(file, plan)) {
    left->remove();
  }
  BatchReport report(database.plan(), database, resume_command(options, file));
  report.all_done_already();
  if (options.json) {
    data_out() << report.json();
  } else if (!options.quiet) {
    out() << report.table();
  }
  return report.exit_code();
}

}  // namespace

int run_on_cluster(const BatchOptions& options) {
  require_sound(options);
  const fs::path file = database_of(options, {});
  if (!options.resume && !results::is_vacant(file)) {
    throw BadInput("there is a file '" + file.string() +
                   "' already; continue it with --resume, or choose another --database");
  }
  if (options.quiet) {
    spdlog::set_level(spdlog::level::err);
  }
  const Plan plan = plan_of(options, {});
  std::optional<ShardFolder> begun;
  if (options.resume) {
    begun = ShardFolder::find(file, plan);
  }
  if (is_merged(file, begun)) {
    return already_there(options, file, plan);
  }
  if (begun && !begun->exists()) {
    begun.reset();  // the command that made it could not submit it
  }
  if (begun) {
    require_same_shards(options, *begun);
  }
  const ShardFolder folder = begun ? *begun : make_folder(options, file, plan);
  ClusterBatch batch(options, file, plan, folder);
  try {
    batch.submit();
  } catch (const std::exception& error) {
    if (!begun && batch.nothing_begun()) {
      const ShardFolder::Turn turn(folder);
      const auto now = ShardFolder::find(file, plan);
      if (!now || now->job().empty()) {  // else another command has submitted it
        folder.remove();
        throw BadInput(std::string(error.what()) + "; nothing was submitted");
      }
    }
    err() << "elsie: " << error.what()
          << (batch.has_asked() ? "; the job array may have been submitted nevertheless; "
                                : "; nothing was submitted now; ")
          << "what was begun is kept; continue with\n  " << resume_command(options, file) << '\n';
    return kOtherFailure;
  }
  if (options.detach) {
    if (!options.quiet) {
      out() << batch.goes_on();
    }
    return kSuccess;
  }
  try {
    if (!batch.follow()) {
      err() << "elsie: interrupted; " << batch.goes_on();
      return kOtherFailure;
    }
  } catch (const std::runtime_error& error) {  // Slurm does not answer
    err() << "elsie: " << error.what() << ";\n" << batch.goes_on();
    return kOtherFailure;
  }
  const ShardFolder::Turn turn(folder);
  // Another command that follows the batch may have been first.
  if (!folder.exists() && !results::is_vacant(file)) {
    return already_there(options, file, plan);
  }
  if (const std::string left = batch.left_over(); !left.empty()) {
    err() << "elsie: tasks of the job array ended before their shards did:\n"
          << left << "go on with\n  " << resume_command(options, file) << '\n';
    return kOtherFailure;
  }
  return batch.conclude();
}

}  // namespace elsie::program

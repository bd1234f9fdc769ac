// elsie batch: does all runs of an experiment and writes a database.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/spdlog.h>

#include "elsie/batch/batch.h"
#include "elsie/cluster/shard_folder.h"
#include "elsie/world/data_directories.h"

#include "arguments.h"
#include "batch_options.h"
#include "batch_report.h"
#include "command.h"
#include "interrupts.h"
#include "output_files.h"
#include "streams.h"

namespace elsie::program {

namespace fs = std::filesystem;
using batch::Plan;
using batch::ResultsDatabase;

namespace {

constexpr const char* kBatchExamples = R"(
Examples:
  elsie batch experiments/top_speed.xml
  elsie batch experiments/top_speed.xml --workers 4 --database speed.sqlite
  elsie batch experiments/top_speed.xml --resume
  elsie batch experiments/top_speed.xml --extend
  elsie batch experiments/top_speed.xml --shard 2/5 --database part2.sqlite
  elsie batch experiments/top_speed.xml --cluster slurm --shards 100 --sbatch=--partition=short

Exit codes: 0 all runs ended normally, 2 bad input (nothing was begun), 3 a plugin failed in
some run, 4 interrupted, or an error.
)";

ResultsDatabase opened(const BatchOptions& options, const fs::path& file, Plan plan) {
  if (!options.resume || results::is_vacant(file)) {
    return ResultsDatabase::create(file, std::move(plan));
  }
  ResultsDatabase database = options.extend ? ResultsDatabase::extend(file, std::move(plan))
                                            : ResultsDatabase::resume(file, std::move(plan));
  if (options.extend && !options.quiet && !options.json) {
    out() << "runs that were added to the experiment: " << database.added_runs() << '\n';
  }
  if (options.again) {
    const std::int64_t count = database.redo_failed();
    if (!options.quiet && !options.json) {
      out() << "runs that failed and are done again: " << count << '\n';
    }
  }
  return database;
}

/// Writes the progress of the batch to a file for other programs.
class ProgressFile {
 public:
  ProgressFile(const BatchOptions& options, ResultsDatabase& database) : file_(options.progress) {
    if (!file_) {
      return;
    }
    for (const batch::CellCount& cell : database.cells()) {
      before_.runs += cell.pending + cell.done + cell.failed;
      before_.ended += cell.done + cell.failed;
      before_.failed += cell.failed;
    }
    cluster::write_count(*file_, before_);
  }

  void write(const batch::Progress& progress) const noexcept {
    if (!file_) {
      return;
    }
    try {
      cluster::write_count(*file_, {.runs = before_.runs,
                                    .ended = before_.ended + progress.ended,
                                    .failed = before_.failed + progress.failed});
    } catch (const std::exception&) {  // errors of the results matter, and are reported
    }
  }

 private:
  const std::optional<std::string> file_;
  cluster::Count before_;
};

int run(BatchOptions options) {
  if (options.experiment.empty()) {
    throw BadInput("EXPERIMENT: the name of a file is missing");
  }
  options.experiment = world::find_document(options.experiment, data_directories());
  if (options.extend) {
    options.resume = true;
  }
  if (options.again && !options.resume) {
    throw BadInput("--again needs --resume and an existing database");
  }
  if (options.cluster) {
    return run_on_cluster(options);
  }
  if (options.shards || options.detach || !options.sbatch.empty()) {
    throw BadInput(std::string(options.shards   ? "--shards"
                               : options.detach ? "--detach"
                                                : "--sbatch") +
                   " is for a cluster; it needs --cluster slurm");
  }
  if (options.progress) {
    if (fs::path(*options.progress).extension() != ".json") {
      throw BadInput("--progress: expected a name that ends in .json, but '" + *options.progress +
                     "' does not");
    }
    require_replaceable(*options.progress, "--progress", "progress file");
  }
  const batch::Shard shard = shard_of(options);
  const fs::path file = database_of(options, shard);
  files::require_apart({{"--database", file}}, {options.experiment});
  if (options.quiet) {
    spdlog::set_level(spdlog::level::err);
  }
  if (options.extend && results::is_vacant(file)) {
    throw BadInput("--extend: there is no database '" + file.string() +
                   "'; begin it without --extend, or name another --database");
  }
  if (!options.resume && !results::is_vacant(file)) {
    throw BadInput("there is a file '" + file.string() +
                   "' already; continue it with --resume, or choose another --database");
  }
  Plan plan = plan_of(options, shard);
  const InterruptGuard interrupt;  // before anything is created
  const bool is_new = results::is_vacant(file);
  std::optional<ResultsDatabase> made(opened(options, file, std::move(plan)));
  if (is_new && InterruptGuard::is_interrupted()) {
    made.reset();
    fs::remove(fs::weakly_canonical(file));
    err() << "elsie: interrupted; nothing was begun\n";
    return kOtherFailure;
  }
  ResultsDatabase& database = *made;
  const ProgressFile progress_file(options, database);
  BatchReport report(database.plan(), database, resume_command(options, file));
  if (database.pending().empty() && options.resume) {
    report.all_done_already();
  } else {
    report.begin(!options.quiet && !options.json);
    std::vector<std::string> worker_template;
    if (!options.fresh_processes) {
      worker_template = {"/proc/self/exe", kTemplateCommand};
    }
    try {
      const bool complete = batch::carry_out(
          database,
          {.command = {"/proc/self/exe", kWorkerCommand},
           .template_command = worker_template,
           .workers =
               options.workers.value_or(std::max<std::size_t>(processors() / options.threads, 1)),
           .stop_descriptor = interrupt.descriptor(),
           .note = [](const std::string& text) { spdlog::info(text); }},
          options.threads, [&](const batch::Progress& progress) {
            report.progress(progress);
            progress_file.write(progress);
          });
      report.end(!complete);
    } catch (...) {
      report.end(true);
      err() << "elsie: the batch stopped early; continue it with\n  "
            << resume_command(options, file) << '\n';
      throw;
    }
  }
  if (options.json) {
    data_out() << report.json();
  } else if (!options.quiet) {
    out() << report.table();
  }
  if (report.interrupted()) {
    out().flush();
    err() << report.interruption();
  }
  return report.exit_code();
}

}  // namespace

void add_batch_command(CLI::App& program, Job& job) {
  CLI::App* command = program.add_subcommand(
      "batch", "Do all runs of an experiment and write a database of results");
  command->footer(kBatchExamples);
  auto options = std::make_shared<BatchOptions>();
  command->add_option("EXPERIMENT", options->experiment, "Experiment file")->required();
  command
      ->add_option("--workers", options->workers,
                   "Runs at the same time, each in a process of its own; default: one for each "
                   "processor, or for each --threads processors")
      ->check(whole_number(1, 1024));
  add_threads_option(*command, options->threads);
  command
      ->add_option("--database", options->database,
                   "Database of results; default: the experiment's file name with .sqlite, in the "
                   "current folder")
      ->type_name("FILE.sqlite");
  command->add_flag("--resume", options->resume,
                    "Continue with an existing database: do only pending runs; without one, begin");
  command->add_flag("--extend", options->extend,
                    "Add to an existing database what the experiment has more: seeds, repetitions, "
                    "levels, worlds. Then continue it as --resume does");
  command->add_flag("--again", options->again, "With --resume: repeat the runs that failed, too");
  command
      ->add_option("--shard", options->shard,
                   "Do only a part of the runs, for several machines: 2/5 is the second of five "
                   "parts; `elsie merge` merges their databases")
      ->type_name("K/N")
      ->capture_default_str();
  command
      ->add_option(
          "--progress", options->progress,
          "Keep the progress of the batch in this file, as a JSON object: runs, ended, failed")
      ->type_name("FILE.json");
  command
      ->add_option("--cluster", options->cluster,
                   "Submit the runs to a cluster as a job array of shards, follow it, and merge "
                   "their databases; with --resume: follow it again, and submit what is left")
      ->check(CLI::IsMember({"slurm"}));
  command
      ->add_option("--shards", options->shards,
                   "With --cluster: number of tasks in the job array; default: 16. --workers then "
                   "applies to each task; default: 1")
      ->check(whole_number(1, 1'000'000));
  command
      ->add_option("--sbatch", options->sbatch,
                   "With --cluster: an option for sbatch, such as --sbatch=--time=02:00:00; may be "
                   "given more than once")
      ->type_name("OPTION")
      ->allow_extra_args(false);
  command->add_flag("--detach", options->detach,
                    "With --cluster: submit without waiting; --resume follows it later");
  // Not listed for users: workers are programs, not copies of one. For tests and benchmarks.
  command->add_flag("--fresh-processes", options->fresh_processes)->group("");
  options->plugins.add_to(*command);
  command->add_flag("--json", options->json,
                    "Print a summary as one JSON object, and nothing else");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  command->callback([&job, options] { job = [options] { return run(*options); }; });
}

}  // namespace elsie::program

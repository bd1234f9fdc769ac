// elsie batch: all runs of an experiment, into a database.
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <sched.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "elsie/batch/batch.h"
#include "elsie/batch/hash.h"
#include "elsie/experiment/reader.h"

#include "arguments.h"
#include "batch_report.h"
#include "command.h"
#include "environment.h"
#include "stop_signals.h"

namespace fs = std::filesystem;
using elsie::batch::Plan;
using elsie::batch::ResultsDatabase;

namespace {

struct Options {
  PluginOptions plugins;
  std::string experiment;
  std::optional<std::size_t> workers;
  std::optional<std::string> database;
  bool resume = false;
  bool again = false;
  std::string shard = "1/1";
  bool json = false;
  bool quiet = false;
};

constexpr const char* kExamples = R"(
Examples:
  elsie batch experiments/beams.xml
  elsie batch experiments/beams.xml --workers 4 --database beams.sqlite
  elsie batch experiments/beams.xml --resume
  elsie batch experiments/beams.xml --shard 2/5 --database beams-2.sqlite

Exit codes: 0 all runs ended by themselves, 2 bad input (nothing was begun), 3 a plugin failed in
some run, 4 interrupted, or an error.
)";

/// As many as this process may use.
std::size_t processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof(set), &set) == 0 && CPU_COUNT(&set) > 0) {
    return static_cast<std::size_t>(CPU_COUNT(&set));
  }
  return 1;
}

elsie::batch::Shard shard_of(const Options& options) {
  const auto shard = elsie::batch::parse_shard(options.shard);
  if (!shard) {
    throw BadInput("--shard: '" + options.shard +
                   "' is no part of an experiment; expected K/N with K from 1 to N, such as 2/5");
  }
  return *shard;
}

fs::path database_of(const Options& options, const elsie::batch::Shard& shard) {
  if (options.database) {
    return *options.database;
  }
  const std::string name = fs::path(options.experiment).stem().string();
  return name +
         (shard.of > 1 ? "-" + std::to_string(shard.index) + "of" + std::to_string(shard.of) : "") +
         ".sqlite";
}

Plan plan_of(const Options& options, const elsie::batch::Shard& shard) {
  const elsie::plugin::Host host = load_plugins(options.plugins);
  const elsie::experiment::ReadOptions reading = experiment_options();
  const auto experiment = elsie::experiment::read_experiment(options.experiment, host, reading);
  return elsie::batch::make_plan(experiment, host,
                                 {.elsie_version = ELSIE_VERSION,
                                  .text = elsie::batch::file_content(options.experiment),
                                  .data_directories = reading.data_directories,
                                  .shard = shard});
}

ResultsDatabase opened(const Options& options, const fs::path& file, const Plan& plan) {
  if (!options.resume || ResultsDatabase::is_vacant(file)) {
    return ResultsDatabase::create(file, plan);
  }
  ResultsDatabase database = ResultsDatabase::resume(file, plan);
  if (options.again) {
    const std::int64_t count = database.redo_failed();
    if (!options.quiet && !options.json) {
      std::cout << "runs that failed and are done again: " << count << '\n';
    }
  }
  return database;
}

/// The command line that goes on with it.
std::string resume_command(const Options& options, const fs::path& database) {
  std::string line = "elsie batch " + shell_word(options.experiment);
  for (const std::string& directory : options.plugins.directories) {
    line += " --plugin-path " + shell_word(directory);
  }
  for (const std::string& file : options.plugins.files) {
    line += " --plugin " + shell_word(file);
  }
  if (options.shard != "1/1") {
    line += " --shard " + options.shard;
  }
  return line + " --database " + shell_word(database.string()) + " --resume";
}

int run(const Options& options) {
  if (options.again && !options.resume) {
    throw BadInput("--again is for a batch that is there already; it needs --resume");
  }
  const elsie::batch::Shard shard = shard_of(options);
  const fs::path file = database_of(options, shard);
  if (options.quiet) {
    spdlog::set_level(spdlog::level::err);
  }
  if (!options.resume && !ResultsDatabase::is_vacant(file)) {
    throw BadInput("there is a file '" + file.string() +
                   "' already; go on with it by --resume, or choose another --database");
  }
  const Plan plan = plan_of(options, shard);
  ResultsDatabase database = opened(options, file, plan);
  BatchReport report(plan, database, resume_command(options, file));
  if (database.pending().empty() && options.resume) {
    report.all_done_already();
  } else {
    const bool bar = !options.quiet && !options.json && isatty(STDERR_FILENO);
    const StopSignals signals;
    report.begin(bar);
    try {
      const bool complete = elsie::batch::carry_out(
          plan, database,
          {.worker = {"/proc/self/exe", kWorkerCommand},
           .workers = options.workers.value_or(processors()),
           .stop_descriptor = signals.descriptor()},
          [&](const elsie::batch::Progress& progress) { report.progress(progress); });
      report.end(!complete);
    } catch (...) {
      report.end(true);
      std::cerr << "elsie: the batch ended before its end; go on with\n  "
                << resume_command(options, file) << '\n';
      throw;
    }
  }
  if (options.json) {
    std::cout << report.json();
  } else if (!options.quiet) {
    std::cout << report.table();
  }
  if (report.interrupted()) {
    std::cout.flush();
    std::cerr << report.interruption();
  }
  return report.exit_code();
}

}  // namespace

void add_batch_command(CLI::App& program, Job& job) {
  CLI::App* command =
      program.add_subcommand("batch", "Do all runs of an experiment, into a database of results");
  command->footer(kExamples);
  auto options = std::make_shared<Options>();
  command->add_option("EXPERIMENT", options->experiment, "Experiment file")->required();
  command
      ->add_option("--workers", options->workers,
                   "Runs at the same time, each in a process of its own; default: one for each "
                   "processor")
      ->check(CLI::Range(1, 1024));
  command
      ->add_option("--database", options->database,
                   "Database of results; default: the experiment's file name with .sqlite, in the "
                   "current folder")
      ->type_name("FILE.sqlite");
  command->add_flag("--resume", options->resume,
                    "Go on with a database that is there: only what is not done yet is done; "
                    "without one, begin");
  command->add_flag("--again", options->again,
                    "With --resume: do the runs again in which a plugin failed or that were ended");
  command
      ->add_option("--shard", options->shard,
                   "Do only a part of the runs, for several machines: 2/5 is the second of five "
                   "parts; `elsie merge` makes one database of theirs")
      ->type_name("K/N")
      ->capture_default_str();
  options->plugins.add_to(*command);
  command->add_flag("--json", options->json,
                    "Print a summary as one JSON object, and nothing else");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  command->callback([&job, options] { job = [options] { return run(*options); }; });
}

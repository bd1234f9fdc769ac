#include "batch_options.h"

#include <sched.h>

#include "elsie/experiment/reader.h"
#include "elsie/process/shell_word.h"
#include "elsie/results/hash.h"

#include "command.h"
#include "output_files.h"
#include "progress.h"
#include "streams.h"

namespace elsie::program {

namespace fs = std::filesystem;
using batch::Plan;
using process::shell_word;

std::size_t processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof(set), &set) == 0 && CPU_COUNT(&set) > 0) {
    return static_cast<std::size_t>(CPU_COUNT(&set));
  }
  return 1;
}

batch::Shard shard_of(const BatchOptions& options) {
  const auto shard = batch::parse_shard(options.shard);
  if (!shard) {
    throw BadInput("--shard: '" + options.shard +
                   "' is not a shard; expected K/N with K from 1 to N, such as 2/5");
  }
  return *shard;
}

fs::path database_of(const BatchOptions& options, const batch::Shard& shard) {
  if (options.database) {
    const fs::path file = *options.database;
    require_database_name(file, "--database");
    return file;
  }
  const std::string name = fs::path(options.experiment).stem().string();
  return name +
         (shard.of > 1 ? "-" + std::to_string(shard.index) + "of" + std::to_string(shard.of) : "") +
         ".sqlite";
}

Plan plan_of(const BatchOptions& options, const batch::Shard& shard) {
  const plugin::Host host = load_plugins(options.plugins);
  CheckProgress progress(!options.quiet && !options.json);
  experiment::ReadOptions reading;
  reading.data_directories = data_directories();
  reading.progress = [&](std::size_t read, std::size_t all) { progress.draw(read, all); };
  const auto experiment = experiment::read_experiment(options.experiment, host, reading);
  for (const std::string& warning : experiment.warnings) {
    err() << warning << '\n';
  }
  return batch::make_plan(experiment, host,
                          {.elsie_version = ELSIE_VERSION,
                           .text = results::file_content(options.experiment),
                           .data_directories = reading.data_directories,
                           .shard = shard});
}

std::string resume_command(const BatchOptions& options, const fs::path& database) {
  std::string line = "elsie batch " + shell_word(options.experiment);
  for (const std::string& directory : options.plugins.directories) {
    line += " --plugin-path " + shell_word(directory);
  }
  for (const std::string& file : options.plugins.files) {
    line += " --plugin " + shell_word(file);
  }
  if (options.workers) line += " --workers " + std::to_string(*options.workers);
  if (options.threads > 1) line += " --threads " + std::to_string(options.threads);
  if (options.shard != "1/1") {
    line += " --shard " + options.shard;
  }
  if (options.cluster) {
    line += " --cluster " + *options.cluster;
    for (const std::string& option : options.sbatch) {
      line += " --sbatch=" + shell_word(option);
    }
  }
  return line + " --database " + shell_word(database.string()) + " --resume";
}

}  // namespace elsie::program

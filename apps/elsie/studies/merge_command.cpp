// elsie merge: merges the databases of an experiment's shards.
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "elsie/base/words.h"
#include "elsie/batch/merge.h"
#include "elsie/process/shell_word.h"
#include "elsie/results/database_file.h"

#include "command.h"
#include "environment.h"
#include "output_files.h"
#include "streams.h"

namespace elsie::program {

using process::shell_word;

namespace {

struct MergeOptions {
  std::string into;
  std::vector<std::string> databases;
  bool quiet = false;
};

constexpr const char* kMergeExamples = R"(
Example:
  elsie merge beams.sqlite beams-1of2.sqlite beams-2of2.sqlite
)";

/// The experiment file of a database.
std::string experiment_of(const std::string& database) {
  return results::open_to_read(database).text("SELECT file FROM about");
}

int merge(const MergeOptions& options) {
  require_database_name(options.into, "OUT");  // otherwise no batch could resume it
  require_writable(options.into, "OUT");
  const batch::Merged merged =
      batch::merge(options.into, {options.databases.begin(), options.databases.end()});
  if (!options.quiet) {
    const std::int64_t to_do = merged.pending + merged.missing;
    out() << options.into << ": " << merged.all_runs - to_do << " of "
          << base::counted(merged.all_runs, "run is", "runs are") << " done\n";
    if (merged.duplicates > 0) {
      out() << base::counted(merged.duplicates, "run")
            << (merged.duplicates == 1 ? " was in several databases, and counts once\n"
                                       : " were in several databases, and count once\n");
    }
    if (to_do > 0) {
      out() << base::counted(to_do, "is", "are") << " still to be done: elsie batch "
            << shell_word(experiment_of(options.into)) << " --database " << shell_word(options.into)
            << " --resume\n";
    }
  }
  return kSuccess;
}

}  // namespace

void add_merge_command(CLI::App& program, Job& job) {
  CLI::App* command = program.add_subcommand(
      "merge", "Merge the databases of an experiment's shards (elsie batch --shard)");
  command->footer(kMergeExamples);
  auto options = std::make_shared<MergeOptions>();
  command->add_option("OUT", options->into, "Database to make")->required();
  command->add_option("DATABASE", options->databases, "Databases of results")->required();
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  command->callback([&job, options] { job = [options] { return merge(*options); }; });
}

}  // namespace elsie::program

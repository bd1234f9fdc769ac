// elsie replay: shows a recording of a run, or repeats a run of a database.
#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <unistd.h>

#include "elsie/base/read_whole.h"
#include "elsie/mcap/reader.h"

#include "arguments.h"
#include "command.h"
#include "make_views.h"
#include "replay.h"

namespace elsie::program {

namespace {

constexpr const char* kReplayExamples = R"(
Examples:
  elsie run worlds/clutter.xml --record clutter.mcap
  elsie replay clutter.mcap
  elsie replay clutter.mcap --picture end.png
  elsie replay clutter.mcap --picture half-way.svg --at 30
  elsie replay clutter.mcap --world again.xml
  elsie replay clutter.mcap --json
  elsie batch experiments/top_speed.xml --database speed.sqlite
  elsie replay speed.sqlite 17
  elsie replay speed.sqlite 17 --picture run.png --record run.mcap
  elsie replay speed.sqlite 17 --world run-17.xml
  elsie replay speed.sqlite 18 --wall-limit 60
  elsie replay speed.sqlite --where "max_speed=0.2; outcome=failure" --record failures

Exit codes for a run of a database: 0 the same result; 1 another result; 2 bad input; 3 a plugin
failed in another way than before, or the run crashed or hung; 4 anything else. For a recording:
0, or 2 when it cannot be read or is damaged.
)";

// Help groups the options for one kind of file under these words.
constexpr const char* kForRecordings = "For recordings";
constexpr const char* kForRuns = "For runs of databases";

/// https://www.sqlite.org/fileformat.html, "The Database Header"
bool may_be_database(const std::filesystem::path& file) {
  constexpr std::string_view kMark{"SQLite format 3\0", 16};
  std::array<char, kMark.size()> start{};
  std::ifstream in(file, std::ios::binary);
  return in.read(start.data(), start.size()) &&
         std::string_view(start.data(), start.size()) == kMark;
}

/// Throws BadInput for an existing file that cannot be read or is empty.
void require_content(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    return;  // opening it reports more
  }
  if (const std::string why = base::why_unreadable(file); !why.empty()) {
    throw BadInput("'" + file + "' " + why +
                   "; expected a recording or a database that `elsie batch` has written");
  }
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  char byte = 0;
  const ssize_t count = descriptor < 0 ? -1 : read(descriptor, &byte, 1);
  const int problem = errno;
  if (descriptor >= 0) {
    close(descriptor);
  }
  if (count < 0) {
    throw BadInput("'" + file + "' cannot be read: " + std::generic_category().message(problem));
  }
  if (count == 0) {
    throw BadInput("'" + file +
                   "' is empty; expected a recording, as `elsie run --record FILE.mcap` writes it, "
                   "or a database that `elsie batch` has written");
  }
}

/// Throws BadInput when an option of this group was given.
void refuse(const CLI::App& command, const std::string& group, const std::string& why) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group() == group && option->count() > 0) {
      throw BadInput(option->get_name() + ": " + why);
    }
  }
}

int replay_matching(const CLI::App& command, const ReplayOptions& options) {
  if (options.run) {
    throw BadInput("--where chooses runs, and a number names one; expected one of the two");
  }
  refuse(command, kForRecordings, "only a recording can be drawn as it was at another time");
  if (options.views.picture || options.views.graph || options.world || options.json) {
    throw BadInput(std::string(options.views.picture ? "--picture"
                               : options.views.graph ? "--graph"
                               : options.world       ? "--world"
                                                     : "--json") +
                   " is for one run; expected its number instead of --where");
  }
  return replay_runs(options);
}

int replay(const CLI::App& command, const ReplayOptions& options) {
  require_content(options.file);
  if (mcap::may_be_mcap(options.file)) {
    refuse(command, kForRuns,
           "'" + options.file + "' is a recording of one run, in which nothing is run again");
    return replay_recording(options);
  }
  const bool database = may_be_database(options.file);
  if (options.where) {
    return replay_matching(command, options);
  }
  if (options.table || options.workers) {
    throw BadInput(std::string(options.table ? "--table" : "--workers") +
                   " is for many runs of a database; it needs --where");
  }
  if (database && !options.run) {
    throw BadInput("'" + options.file +
                   "' is a database of many runs; expected the number of one after it, or --where");
  }
  if (!options.run) {
    if (std::filesystem::is_regular_file(options.file)) {
      throw BadInput("'" + options.file +
                     "' is neither a recording, as `elsie run --record FILE.mcap` writes it, nor a "
                     "database that `elsie batch` has written");
    }
    return replay_recording(options);
  }
  refuse(command, kForRecordings, "only a recording can be drawn as it was at another time");
  return replay_run(options);
}

}  // namespace

void add_replay_command(CLI::App& program, Job& job) {
  CLI::App* command =
      program.add_subcommand("replay", "Show a recording of a run, or repeat a run of a database");
  command->footer(kReplayExamples);
  auto options = std::make_shared<ReplayOptions>();
  command
      ->add_option("FILE", options->file,
                   "Recording, written by `elsie run --record FILE.mcap`, or database, written by "
                   "`elsie batch`")
      ->required();
  command
      ->add_option("RUN", options->run,
                   "Number of the run in the database, which is repeated and compared")
      ->check(whole_number())
      ->group(kForRuns);
  CLI::Option* picture = command
                             ->add_option("--picture", options->views.picture,
                                          "Draw the world with the robots' trajectories at the end "
                                          "of the run; for a recording, from its contents only")
                             ->type_name("FILE.png|FILE.svg");
  command->add_option("--width", options->views.picture_width, "Width of the picture in pixels")
      ->needs(picture)
      ->check(whole_number(200, 8000))
      ->capture_default_str();
  command
      ->add_option("--graph", options->views.graph,
                   "Draw the states or the tree of a robot's coordinators at the end of the run, "
                   "with those that are running in colour; by default of the first robot that has "
                   "such a coordinator")
      ->type_name("[ROBOT=]FILE.png|FILE.svg");
  command
      ->add_option("--at", options->at,
                   "Draw the state at this simulated time (s) instead of the end")
      ->check(non_negative_number())
      ->group(kForRecordings);
  command
      ->add_option("--world", options->world,
                   "Write the world as it was at the start of the run, with the edits that the run "
                   "received under <changes>: `elsie run` then repeats the run. With this option a "
                   "run of a database is not repeated")
      ->type_name("FILE.xml");
  command->add_flag("--json", options->json,
                    "Print what a recording has, or the seed and the command of --world, as JSON");
  options->plugins.add_to(*command);
  const auto before = command->get_options().size();
  command
      ->add_option("--where", options->where,
                   "Instead of RUN: repeat all runs that match, each in a process of its own, and "
                   "record them in the folder that --record then names, by cell and seed. "
                   "FACTOR=LEVEL|LEVEL; FACTOR=LEVEL, with \"*\" for any text; state, outcome and "
                   "seed count as factors")
      ->type_name("WHICH");
  command->add_flag("--table", options->table,
                    "With --where: write a table (.csv) next to each recording (.mcap)");
  command
      ->add_option("--workers", options->workers,
                   "With --where: runs at the same time; default: one for each processor")
      ->check(whole_number(1, 1024));
  options->views.record.add_to(*command);
  describe_formats(*command);
  command
      ->add_option(
          "--wall-limit", options->wall_limit_s,
          "Seconds on the clock, once plugins are loaded, after which the run is ended; 0: "
          "never. Default: the batch's limit for a run that met it, else never")
      ->check(non_negative_number())
      ->type_name("SECONDS");
  command->add_flag("--quiet", options->quiet,
                    "Print nothing but errors and whether the result is the same");
  const auto all = command->get_options();
  for (std::size_t i = before; i < all.size(); ++i) {
    all[i]->group(kForRuns);
  }
  command->callback([&job, options, command] {
    job = [options, command] { return replay(*command, *options); };
  });
}

}  // namespace elsie::program

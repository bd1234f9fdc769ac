// elsie run: one world, one run.
#include <iostream>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "elsie/simulation/recording.h"
#include "elsie/simulation/simulation.h"
#include "elsie/simulation/tracks.h"
#include "elsie/world/reader.h"

#include "arguments.h"
#include "command.h"
#include "environment.h"
#include "progress.h"
#include "run_report.h"
#include "top_view.h"

namespace {

struct RunOptions {
  PluginOptions plugins;
  std::string world;
  std::uint64_t seed = 1;
  std::optional<double> duration;
  std::vector<std::string> overrides;
  std::optional<std::string> record;
  double record_rate = 10.0;
  bool record_times = false;
  std::optional<std::string> picture;
  bool json = false;
  bool quiet = false;
};

constexpr const char* kExamples = R"(
Examples:
  elsie run worlds/clutter.xml
  elsie run worlds/clutter.xml --seed 7 --duration 60 --picture clutter.png
  elsie run worlds/clutter.xml --record clutter.csv --record-rate 20
  elsie run worlds/clutter.xml --set 'robot[r1]/behavior[wander]/@speed=15' --json

The run ends with exit code 0 when the world's goals are reached, 1 when they are not.
)";

/// Everything that watches one run.
class Watchers {
 public:
  explicit Watchers(const RunOptions& options) {
    if (options.record) {
      recorder_.emplace(*options.record, options.record_rate, options.record_times);
      all_.push_back(&*recorder_);
    }
    if (options.picture) {
      tracks_.emplace();
      all_.push_back(&*tracks_);
    }
    if (!options.quiet && !options.json && isatty(STDERR_FILENO)) {
      progress_.emplace();
      all_.push_back(&*progress_);
    }
    all_.push_back(&interrupt_);
  }
  Watchers(const Watchers&) = delete;
  Watchers& operator=(const Watchers&) = delete;

  std::span<elsie::simulation::Observer* const> all() const { return all_; }
  const elsie::simulation::TrackRecorder* tracks() const { return tracks_ ? &*tracks_ : nullptr; }

 private:
  std::optional<elsie::simulation::CsvRecorder> recorder_;
  std::optional<elsie::simulation::TrackRecorder> tracks_;
  std::optional<ProgressBar> progress_;
  InterruptGuard interrupt_;
  std::vector<elsie::simulation::Observer*> all_;
};

void check(const RunOptions& options) {
  if (options.record) {
    require_recording(*options.record, "--record");
  }
  if (options.picture) {
    require_picture(*options.picture, "--picture");
  }
}

int run(const RunOptions& options) {
  check(options);
  if (options.quiet) {
    spdlog::set_level(spdlog::level::err);
  }
  const elsie::plugin::Host host = load_plugins(options.plugins);
  elsie::world::World world =
      elsie::world::read_world(options.world, host, read_options(options.overrides));
  if (options.duration) {
    world.limits.time = *options.duration;
  }
  elsie::simulation::Simulation simulation(std::move(world), host,
                                           {options.seed, options.record_times});
  Watchers watchers(options);
  const auto draw_as = [&](const std::string& line) {
    if (options.picture) {
      draw(simulation, watchers.tracks(), {line}, *options.picture, 1000);
    }
  };
  try {
    const elsie::simulation::RunResult result = simulation.run(watchers.all());
    draw_as(headline(result) + "  (seed " + std::to_string(result.seed) + ")");
    if (options.json) {
      std::cout << json(result);
    } else if (!options.quiet) {
      std::cout << table(result);
    }
    return result.outcome == elsie::simulation::Outcome::success ? kSuccess : kGoalMissed;
  } catch (const elsie::simulation::PluginFault& fault) {
    try {
      draw_as(fault.what());
    } catch (const std::exception& error) {
      std::cerr << "elsie: " << error.what() << '\n';  // the fault is what counts
    }
    throw;
  } catch (const Interrupted&) {
    draw_as("interrupted");
    std::cerr << "elsie: interrupted after " << simulation.time_s()
              << " s of simulated time; what was recorded until then is kept\n";
    return kOtherFailure;
  }
}

}  // namespace

void add_run_command(CLI::App& program, Job& job) {
  CLI::App* command = program.add_subcommand("run", "Run a world until its goals or limits end it");
  command->footer(kExamples);
  auto options = std::make_shared<RunOptions>();
  command->add_option("WORLD", options->world, "World file")->required();
  command->add_option("--seed", options->seed, "Seed of all randomness in the run")
      ->check(seed_number())
      ->capture_default_str();
  command
      ->add_option("--duration", options->duration,
                   "Simulated seconds after which the run ends, instead of the world's limit")
      ->check(positive_number());
  command
      ->add_option(
          "--set", options->overrides,
          "Change an attribute of the world, e.g. 'robot[r1]/@max_speed=0.3'; may be repeated")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  options->plugins.add_to(*command);
  command
      ->add_option("--record", options->record,
                   "Write poses, commands, readings and the coordinators' traces as a table")
      ->type_name("FILE.csv");
  command->add_option("--record-rate", options->record_rate, "Rows per simulated second and robot")
      ->needs("--record")
      ->check(positive_number())
      ->capture_default_str();
  command
      ->add_flag("--record-times", options->record_times,
                 "Record how long each behaviour takes, too (differs from run to run)")
      ->needs("--record");
  command
      ->add_option("--picture", options->picture,
                   "Draw the world at the end of the run with the robots' trajectories")
      ->type_name("FILE.png|FILE.svg");
  command->add_flag("--json", options->json,
                    "Print the result as one JSON object, and nothing else");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  command->callback([&job, options] { job = [options] { return run(*options); }; });
}

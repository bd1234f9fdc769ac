// elsie run: one world, one run.
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/spdlog.h>

#include "elsie/process/crash_report.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/reader.h"
#include "elsie/world/tree.h"

#include "arguments.h"
#include "command.h"
#include "command_module.h"
#include "environment.h"
#include "live.h"
#include "run_report.h"
#include "run_views.h"
#include "streams.h"
#include "watchers.h"

namespace elsie::program {

namespace {

struct RunOptions {
  PluginOptions plugins;
  std::string world;
  std::uint64_t seed = 1;
  std::optional<double> duration;
  std::vector<std::string> edits;
  std::vector<std::string> changes;
  ViewOptions views;
  bool watch = false;
  std::optional<double> speed;
  double time_budget_ms = 0.0;
  double memory_budget_mb = 0.0;
  std::size_t threads = 1;
  bool json = false;
  bool quiet = false;
};

constexpr const char* kRunExamples = R"(
Examples:
  elsie run worlds/clutter.xml
  elsie run worlds/clutter.xml --seed 7 --duration 60 --picture clutter.png
  elsie run worlds/clutter.xml --record clutter.csv --record-rate 20
  elsie run worlds/find_resource.xml --record find.mcap --record-images
  elsie run worlds/clutter.xml --record clutter.mcap && elsie explain clutter.mcap
  elsie run worlds/clutter.xml --set 'robot[r1]/behavior[wander]/@speed=15' --json
  elsie run worlds/ten_robots.xml --threads 2
  elsie run worlds/ten_robots.xml --live
  elsie run my_world.xml --plugin my_behavior.cpp --watch --speed 1
  elsie run worlds/clutter.xml --at '5:robot[r1]/@max_speed=0.2' --at '10:robot[r1]/@max_speed=0.4'

The run ends with exit code 0 when the world's goals are reached, 1 when they are not, 3 when a
plugin failed, 4 when the physics failed.
)";

/// TIME:EDIT. Throws BadInput.
simulation::TimedEdit change_of(const std::string& text) {
  const auto fail = [&](const std::string& problem) {
    throw BadInput("--at " + text + ": " + problem +
                   "; expected TIME:EDIT, as in '5:robot[r1]/@max_speed=0.2'");
  };
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) {
    fail("there is no ':' after a time");
  }
  const auto time = parse_number(std::string_view(text).substr(0, colon));
  if (!time) {
    fail("'" + text.substr(0, colon) + "' is not a time in seconds");
  }
  const std::string edit = text.substr(colon + 1);
  const std::size_t equals = world::end_of_path(edit);
  if (equals == std::string::npos) {
    fail("there is no '=' after a path");
  }
  return {*time, {edit.substr(0, equals), edit.substr(equals + 1)}};
}

std::vector<simulation::TimedEdit> edits_of(const RunOptions& options) {
  std::vector<simulation::TimedEdit> changes;
  for (const std::string& text : options.changes) {
    changes.push_back(change_of(text));
  }
  return changes;
}

simulation::Budget budget_of(const RunOptions& options) {
  return {1e-3 * options.time_budget_ms, static_cast<std::size_t>(1e6 * options.memory_budget_mb)};
}

/// Stops plugins that do not return, if there is a time limit. If a plugin returns late by less
/// than this, the run ends in order.
constexpr double kGrace = 1.0;  // s
std::optional<process::Watchdog> watchdog_of(const RunOptions& options) {
  if (options.time_budget_ms <= 0.0) {
    return std::nullopt;
  }
  return std::optional<process::Watchdog>(std::in_place, budget_of(options).time_s + kGrace,
                                          kPluginFailed);
}

/// Pictures for sensors with cameras; the library is loaded when a world has one.
std::unique_ptr<simulation::CameraRenderer> cameras(const world::World& world) {
  return command_module().make_cameras(world);
}

simulation::Options simulation_options(const RunOptions& options) {
  return {.seed = options.seed,
          .measure_time = options.views.record.times,
          .data_directories = data_directories(),
          .budget = budget_of(options),
          .threads = options.threads,
          .time_limit_s = options.duration,
          .cameras = cameras};
}

/// The simulation of a valid world, with changes that can be made. `found` gets the files that the
/// world names.
simulation::Simulation simulation_of(const RunOptions& options, const plugin::Host& host,
                                     std::span<const simulation::TimedEdit> changes,
                                     std::map<std::string, std::string>& found) {
  world::ReadOptions reading = read_options(options.edits, options.seed);
  reading.found = &found;
  reading.time_limit_s = options.duration;
  world::World world = world::read_world(options.world, host, reading);
  simulation::Simulation simulation(std::move(world), host, simulation_options(options));
  try {
    simulation.check(changes);
  } catch (const simulation::EditRefused& refused) {
    throw BadInput(refused.report());
  }
  return simulation;
}

/// How to make the run once more. The host must outlive it.
RunAgain again_of(const RunOptions& options, const simulation::Simulation& simulation,
                  const plugin::Host& host, std::vector<simulation::TimedEdit> edits) {
  world::World world = simulation.start();
  world.limits.wall_time.reset();  // it is the first run that the clock ends
  return {[&options, &host, world = std::move(world)] {
            return std::make_unique<simulation::Simulation>(world, host,
                                                            simulation_options(options));
          },
          std::move(edits)};
}

int run(const RunOptions& options) {
  if (options.threads > 1 && (options.time_budget_ms > 0.0 || options.memory_budget_mb > 0.0)) {
    throw BadInput(
        "--threads " + std::to_string(options.threads) +
        ": a budget of a plugin is measured in one thread; leave out --threads or the budget");
  }
  ViewOptions asked = options.views;
  asked.live_speed = options.speed.value_or(asked.live_speed);
  asked.quiet = options.quiet;
  auto views = asked.any() ? command_module().make_views(asked) : nullptr;
  const auto changes = edits_of(options);
  if (options.quiet) {
    spdlog::set_level(spdlog::level::err);
  }
  const auto watch = options.watch ? watch_plugins(options.plugins) : nullptr;
  const auto host = watch ? plugin::Host() : load_plugins(options.plugins);
  std::map<std::string, std::string> found;
  simulation::Simulation simulation =
      simulation_of(options, watch ? watch->host() : host, changes, found);
  std::function<void(simulation::Simulation&)> renew;
  if (watch) {
    renew = [&](auto& running) { replace_what_changed(*watch, running, options.quiet); };
  }
  if (views) {
    views->open(
        simulation, read_files(options.world, found, options.plugins),
        options.views.live && !watch ? again_of(options, simulation, host, changes) : RunAgain());
  }
  std::optional<Pacer> pacer;
  std::vector<simulation::Observer*> others;
  if (options.speed && !options.views.live) {
    others.push_back(&pacer.emplace(*options.speed));
  }
  const Watchers watchers(std::move(views), !options.quiet && !options.json, others);
  const auto draw_as = [&](const std::string& line) { watchers.draw(simulation, line); };
  const auto watchdog = watchdog_of(options);
  try {
    const simulation::RunResult result = simulation.run(watchers.all(), changes, renew);
    // The result of the run comes first: it is not lost if the picture cannot be written.
    if (options.json) {
      data_out() << json(result);
    } else if (!options.quiet) {
      out() << table(result);
    }
    out().flush();
    draw_as(headline(result) + "  (seed " + std::to_string(result.seed) + ")");
    watchers.linger(simulation);
    return result.outcome == simulation::Outcome::success ? kSuccess : kGoalMissed;
  } catch (const simulation::PluginFault& fault) {
    try {
      draw_as(fault.what());
    } catch (const std::exception& error) {
      err() << "elsie: " << error.what() << '\n';  // the fault is more important
    }
    throw;
  } catch (const simulation::PhysicsFault& fault) {
    draw_as(fault.what());
    throw;
  } catch (const simulation::EditRefused& refused) {
    draw_as(refused.what());
    throw BadInput(refused.report() +
                   "\nthe run ended there; what was recorded until then is kept");
  } catch (const Interrupted&) {
    draw_as("interrupted");
    err() << "elsie: interrupted after " << simulation.time_s()
          << " s of simulated time; what was recorded until then is kept\n";
    return kOtherFailure;
  }
}

}  // namespace

void add_run_command(CLI::App& program, Job& job) {
  CLI::App* command = program.add_subcommand("run", "Run a world until its goals or limits end it");
  command->footer(kRunExamples);
  auto options = std::make_shared<RunOptions>();
  command->add_option("WORLD", options->world, "World file")->required();
  command->add_option("--seed", options->seed, "Seed of all randomness in the run")
      ->check(seed_number())
      ->capture_default_str();
  command
      ->add_option("--duration", options->duration,
                   "Simulated seconds after which the run ends, instead of the world's limit")
      ->check(positive_number(1e9));  // as limits/@time
  command
      ->add_option(
          "--set", options->edits,
          "Change an attribute of the world, e.g. 'robot[r1]/@max_speed=0.3'; may be repeated")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  command
      ->add_option(
          "--at", options->changes,
          "Edit the world while it runs, before the first step at this simulated time (s) "
          "or after it: any edit that --set takes, e.g. '5:robot[r1]/@max_speed=0.2' or "
          "'5:obstacle[+]=<static_box x=\"1\"/>'; may be repeated; edits with the same time "
          "are made together")
      ->type_name("TIME:EDIT")
      ->allow_extra_args(false);
  options->plugins.add_to(*command);
  command->add_flag("--watch", options->watch,
                    "Replace plugins while the world runs when their libraries, or the sources "
                    "given by --plugin, change on disk");
  command
      ->add_option("--speed", options->speed,
                   "Simulated seconds per second on the clock, at most; default: as fast as it "
                   "goes, and 1 with --live. 1 is real time")
      ->check(positive_number())
      ->type_name("FACTOR");
  command
      ->add_option("--live", options->views.live,
                   "Show the run in Foxglove while it happens, and let viewers pause it and go to "
                   "other times; stays until Ctrl-C. The port is 8765 by default, 0 is any free "
                   "one; other machines are let in only at an address such as 0.0.0.0:8765")
      ->expected(0, 1)
      ->default_str("8765")
      ->type_name("[[ADDRESS:]PORT]");
  command
      ->add_option("--live-origin", options->views.live_origins,
                   "Let pages of this origin watch, too, e.g. https://viewer.example.org; may be "
                   "repeated")
      ->needs("--live")
      ->allow_extra_args(false)
      ->type_name("ORIGIN");
  options->views.record.add_to(*command);
  command
      ->add_option("--picture", options->views.picture,
                   "Draw the world at the end of the run with the robots' trajectories")
      ->type_name("FILE.png|FILE.svg");
  options->views.paths.add_to(*command);
  command
      ->add_option("--graph", options->views.graph,
                   "Draw the states or the tree of a robot's coordinators at the end of the run, "
                   "with those that are running in colour; by default of the first robot that has "
                   "such a coordinator")
      ->type_name("[ROBOT=]FILE.png|FILE.svg");
  command
      ->add_option("--save-images", options->views.image_folder,
                   "Save what every camera sees, raw and processed, in this folder, as PNG files "
                   "named after step, robot and sensor")
      ->type_name("DIR");
  command
      ->add_option("--save-images-every", options->views.image_period_s,
                   "Simulated time from one saved image of a camera to the next; default: every "
                   "control period")
      ->needs("--save-images")
      ->check(positive_number())
      ->type_name("SECONDS");
  command
      ->add_option("--time-budget", options->time_budget_ms,
                   "End the run when a plugin takes longer than this for one answer, by the clock, "
                   "and name it; the run then depends on the machine")
      ->check(positive_number())
      ->type_name("MS");
  command
      ->add_option("--memory-budget", options->memory_budget_mb,
                   "End the run when the memory of a plugin grows by more than this, and name the "
                   "plugin")
      ->check(positive_number())
      ->type_name("MB");
  add_threads_option(*command, options->threads);
  command->add_flag("--json", options->json,
                    "Print the result as one JSON object, and nothing else");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  command->callback([&job, options] { job = [options] { return run(*options); }; });
}

}  // namespace elsie::program

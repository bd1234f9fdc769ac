#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "elsie/batch/results_database.h"
#include "elsie/render/world_cameras.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/reader.h"

#include "command.h"
#include "make_views.h"
#include "replay.h"
#include "restored_run.h"
#include "run_report.h"
#include "same_run.h"
#include "start_world.h"
#include "streams.h"
#include "wall_limit.h"
#include "watchers.h"

namespace elsie::program {

using batch::RunState;
using batch::StoredRun;
using simulation::PluginFault;
using simulation::RunResult;
using simulation::Simulation;

namespace {

StoredRun stored_run(const ReplayOptions& options) {
  auto database = batch::ResultsDatabase::open(options.file);
  auto run = database.run(*options.run);
  if (!run) {
    throw BadInput(database.why_no_run(*options.run));
  }
  if (run->record.state == RunState::pending) {
    throw BadInput("run " + std::to_string(*options.run) + " of '" + options.file +
                   "' is still to be done; do it with `elsie batch --resume`");
  }
  return *std::move(run);
}

void tell_of(const StoredRun& run, const ReplayOptions& options) {
  if (options.quiet) {
    return;
  }
  out() << "run " << run.job.run << " of " << run.experiment << ": " << run.cell << ", seed "
        << run.job.seed << '\n'
        << "before: " << to_string(run.record.state) << ", " << run.record.message << '\n';
  out().flush();  // a plugin may end the program
}

/// Prints whether the result is the same, and returns it.
bool compare(const StoredRun& run, const RunResult& result, const RestoredRun& restored) {
  const std::string hash = "state hash " + simulation::hash_text(result.state_hash);
  constexpr const char* kNot = "not the same: ";
  if (run.record.state == RunState::done) {
    const std::vector<std::string> different = differences(run.record, result);
    if (different.empty()) {
      out() << "the same: " << hash << '\n';
      return true;
    }
    for (const std::string& line : different) {
      out() << (&line == &different.front() ? kNot : "              ") << line << '\n';
    }
  } else {
    out() << kNot << "it ended normally, " << hash << '\n';
  }
  if (!restored.differences().empty()) {
    out() << "the differences from the original run, listed above, may be the reason\n";
  }
  return false;
}

bool is_as_before(const StoredRun& run, const PluginFault& fault) {
  return run.record.state == RunState::fault && run.record.plugin == fault.plugin &&
         run.record.robot == fault.robot && run.record.step == fault.step;
}

/// The wall limit of the replay, s; 0: none. A run that hung has that of its batch.
double wall_limit_of(const StoredRun& run, const ReplayOptions& options) {
  return options.wall_limit_s.value_or(run.record.state == RunState::hang ? run.wall_limit_s : 0.0);
}

/// Says how a run that did not reach its end differs from the one before.
void tell_of_limit(const StoredRun& run, const WallLimit& limit) {
  const bool hung = run.record.state == RunState::hang;
  out() << "not the same: the run " << (hung ? "is slow, and does not hang: " : "has not ended: ")
        << limit.what_happened() << ", before " << to_string(run.record.state) << ": "
        << run.record.message << '\n'
        << (hung ? "--wall-limit gives it more time\n" : "");
}

/// Writes the world of the run. Data files that have changed since are written next to it.
int write_world(const StoredRun& run, const ReplayOptions& options) {
  require_new_world(*options.world);
  const std::filesystem::path beside = std::filesystem::path(*options.world).replace_extension() +=
      "-files";
  const RestoredRun restored(run, options.plugins, beside);
  for (const std::string& difference : restored.differences()) {
    err() << "elsie: " << difference << '\n';
  }
  world::ReadOptions reading = read_options();
  reading.files = restored.files();
  const StartWorld written =
      write_start_world({run.job.world_text, run.job.world_file, run.job.seed}, restored.host(),
                        reading, options.plugins, *options.world);
  if (options.json) {
    const nlohmann::ordered_json object{{"seed", run.job.seed}, {"command", written.command}};
    data_out() << object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)
               << '\n';
  } else {
    out() << written.in_words();
  }
  return kSuccess;
}

}  // namespace

int replay_run(const ReplayOptions& options) {
  if (options.json && !options.world) {
    throw BadInput(
        "--json: for a run of a database, it needs --world; `elsie report --json` "
        "has the results");
  }
  auto views = make_views(options.views);
  if (options.quiet) {
    spdlog::set_level(spdlog::level::err);
  }
  const StoredRun run = stored_run(options);
  if (options.world) {
    return write_world(run, options);
  }
  RestoredRun restored(run, options.plugins);
  for (const std::string& difference : restored.differences()) {
    err() << "elsie: " << difference << '\n';
  }
  tell_of(run, options);
  WallLimit limit(wall_limit_of(run, options));
  limit.start_clock();
  Simulation simulation(restored.world(), restored.host(),
                        {.seed = run.job.seed,
                         .measure_time = options.views.record.times,
                         .data_directories = data_directories(),
                         .files = restored.files(),
                         .cameras = render::world_cameras});
  views->open(simulation, read_files(options.file, restored.files(), options.plugins), {});
  simulation::Observer* const limits[] = {&limit};
  const Watchers watchers(std::move(views), !options.quiet, limits);
  const auto draw_as = [&](const std::string& line) { watchers.draw(simulation, line); };
  try {
    const RunResult result = simulation.run(watchers.all());
    const bool same = compare(run, result, restored);
    if (!options.quiet) {
      out() << '\n' << table(result);
    }
    out().flush();
    draw_as(headline(result) + "  (seed " + std::to_string(result.seed) + ")");
    return same ? kSuccess : kGoalMissed;
  } catch (const PluginFault& fault) {
    draw_as(fault.what());
    if (!is_as_before(run, fault)) {
      throw;
    }
    out() << "the same: " << fault.what() << '\n';
    return kSuccess;
  } catch (const simulation::PhysicsFault& fault) {
    draw_as(fault.what());
    if (run.record.state != RunState::error || run.record.message != fault.what()) {
      throw;
    }
    out() << "the same: " << fault.what() << '\n';
    return kSuccess;
  } catch (const WallLimitMet&) {
    draw_as("ended at its wall limit");
    tell_of_limit(run, limit);
    return kGoalMissed;
  } catch (const Interrupted&) {
    draw_as("interrupted");
    err() << "elsie: interrupted after " << simulation.time_s()
          << " s of simulated time; what was recorded until then is kept\n";
    return kOtherFailure;
  }
}

}  // namespace elsie::program

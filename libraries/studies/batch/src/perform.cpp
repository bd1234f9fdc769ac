#include "elsie/batch/perform.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "elsie/base/thrown.h"
#include "elsie/render/world_cameras.h"
#include "elsie/simulation/simulation.h"
#include "elsie/traces/account_recorder.h"
#include "elsie/traces/tracks.h"
#include "elsie/world/reader.h"

#include "run_texts.h"

namespace elsie::batch {
namespace {

std::atomic<std::uint64_t> current_step{0};
std::atomic<double> current_time_s{0.0};

void note_moment(const simulation::Simulation& run) {
  current_step = run.steps();
  current_time_s = run.time_s();
}

class StepTeller final : public simulation::Observer {
 public:
  void started(const simulation::Simulation& run) override { note_moment(run); }
  void stepped(const simulation::Simulation& run) override { note_moment(run); }
};

/// All observers of the run.
struct Watchers {
  explicit Watchers(double trajectory_period_s) : tracks(trajectory_period_s) {}

  StepTeller step;
  traces::TrackRecorder tracks;
  traces::AccountRecorder accounts;
};

std::vector<plugin::SearchDirectory> libraries_of(const Job& job) {
  std::vector<plugin::SearchDirectory> libraries;
  for (const std::string& library : job.libraries) {
    libraries.push_back({library, "the batch"});
  }
  return libraries;
}

world::World world_of(const Job& job, const plugin::Host& host) {
  world::ReadOptions options;
  options.files = job.files;
  return world::parse_world(job.world_text, job.world_file, host, options);
}

bool is_finite(const simulation::RobotResult& robot) {
  return std::isfinite(robot.distance_m) && std::isfinite(robot.energy) &&
         std::isfinite(robot.pose.x) && std::isfinite(robot.pose.y) &&
         std::isfinite(robot.pose.heading_rad);
}

/// Copies results from a run into its record, however it ended.
void take(const simulation::Simulation& run, const Watchers& watchers, RunRecord& record) {
  record.steps = run.steps();
  record.simulated_s = run.time_s();
  for (std::size_t i = 0; i < watchers.tracks.tracks().size(); ++i) {
    record.trajectories.push_back(trajectory_of(run.world().robots[i].id,
                                                watchers.tracks.tracks()[i],
                                                watchers.tracks.period_s(), kMostPoses));
  }
  record.timelines = timelines_of(watchers.accounts, kMostEpisodes);
  // Last, because a measure may fail in it.
  const simulation::RunResult result = run.result();
  record.wall_s = result.wall_s;
  if (std::all_of(result.robots.begin(), result.robots.end(), is_finite)) {
    record.robots = result.robots;
  }
  record.notes = result.notes;
  record.solver_gave_up = result.solver.gave_up;
  record.solver_unsolved = result.solver.unsolved;
  for (const simulation::LearningCurve& curve : result.curves) {
    record.curves.push_back(curve_of(curve, kMostCurvePoints));
  }
  for (const simulation::EventRecord& event : result.events) {
    if (record.events.size() == kMostEvents) {
      record.notes.push_back({"", "",
                              std::to_string(result.events.size() - kMostEvents) +
                                  " events after the first " + std::to_string(kMostEvents) +
                                  " were left out."});
      break;
    }
    record.events.push_back({event.time_s, event.robot, event.name(), event.detail()});
  }
}

void run_to_end(simulation::Simulation& run, const Job& job, RunRecord& record) {
  Watchers watchers(job.trajectory_period_s);
  simulation::Observer* const observers[] = {&watchers.step, &watchers.tracks, &watchers.accounts};
  simulation::RunResult result;
  try {
    result = run.run(observers);
  } catch (...) {
    try {
      take(run, watchers, record);
    } catch (...) {
      // A measure cannot report; the fault that ended the run is reported instead.
    }
    throw;
  }
  take(run, watchers, record);
  record.state = RunState::done;
  record.outcome = result.outcome;
  record.message = result.reason;
  record.state_hash = simulation::hash_text(result.state_hash);
  record.measures = result.measures;
}

}  // namespace

Preparation::Preparation(const Job& job) : host(libraries_of(job)) {}

void Preparation::make(const Job& job, const simulation::MakeCameraRenderer& cameras) {
  if (!run) {
    run.emplace(
        world_of(job, host), host,
        simulation::Options{
            .files = job.files, .threads = job.threads, .cameras = cameras, .begin_later = true});
  }
}

RunRecord perform(const Job& job, std::unique_ptr<Preparation> prepared) {
  RunRecord record;
  current_step = 0;
  current_time_s = 0.0;
  try {
    const auto own = prepared ? std::move(prepared) : std::make_unique<Preparation>(job);
    own->make(job, render::world_cameras);
    own->run->reset(job.seed);
    run_to_end(*own->run, job, record);
  } catch (const simulation::PluginFault& fault) {
    record.state = RunState::fault;
    record.message = fault.what();
    record.plugin = fault.plugin;
    record.robot = fault.robot;
    record.step = fault.step;
  } catch (const simulation::PhysicsFault& fault) {
    record.state = RunState::error;
    record.message = fault.what();
    if (!fault.robot.empty()) {
      record.robot = fault.robot;
    }
    record.step = fault.step;
  } catch (...) {
    record.state = RunState::error;
    record.message = base::what_was_thrown();
  }
  if (record.state != RunState::done) {
    record.outcome.reset();
  }
  return record;
}

Moment moment_at_work() noexcept { return {current_step, current_time_s}; }

}  // namespace elsie::batch

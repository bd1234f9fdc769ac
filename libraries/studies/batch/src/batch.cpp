#include "elsie/batch/batch.h"

#include <chrono>
#include <map>
#include <stdexcept>
#include <utility>

#include "elsie/batch/estimate.h"
#include "elsie/batch/worker_pool.h"

namespace elsie::batch {

namespace {

/// Runs of one cell; with fewer, it is no use to keep a process that has read their world.
constexpr std::int64_t kFewestToShare = 3;

}  // namespace

Job job_of(const Plan& plan, const PlannedRun& run) {
  const PlannedCell& cell = plan.cells[run.cell];
  Job job;
  job.run = run.id;
  job.repetition = run.repetition;
  const auto layout = cell.layouts.find(run.seed);
  if (layout == cell.layouts.end()) {
    job.world_text = cell.world_text;
    job.cell = run.cell;
  } else {
    job.world_text = layout->second.world_text;
  }
  job.world_file = cell.world_file;
  for (const PlannedCell::Data& data : cell.data) {
    job.files[data.name] = plan.files[data.file].path;
  }
  job.libraries = plan.libraries(cell);
  job.seed = run.seed;
  job.trajectory_period_s = plan.trajectory_period_s;
  return job;
}

namespace {

/// The pending runs in the order in which they are done.
std::vector<PlannedRun> ordered(ResultsDatabase& database) {
  try {
    return in_order(database.plan(), database.pending());
  } catch (const std::out_of_range& run) {
    throw DatabaseError(std::string(run.what()) + " of the database '" + database.file().string() +
                        "' is not among those of the experiment");
  }
}

Estimate estimate_of(ResultsDatabase& database, const std::vector<PlannedRun>& pending,
                     std::size_t workers) {
  std::vector<std::int64_t> counts(database.plan().cells.size(), 0);
  for (const PlannedRun& run : pending) {
    ++counts[run.cell];
  }
  Estimate estimate(std::move(counts), workers);
  for (const CellTime& time : database.times()) {
    estimate.add_known(time.cell, time.wall_s, time.runs);
  }
  return estimate;
}

}  // namespace

bool carry_out(ResultsDatabase& database, PoolOptions options, std::size_t threads,
               const std::function<void(const Progress&)>& watch) {
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](Clock::duration time) {
    return std::chrono::duration<double>(time).count();
  };
  const Plan& plan = database.plan();
  const std::vector<PlannedRun> pending = ordered(database);
  Progress progress{.runs = static_cast<std::int64_t>(pending.size())};
  Estimate estimate = estimate_of(database, pending, options.workers);
  FileCheck files(plan);
  const auto start = Clock::now();
  options.wall_limit_s = plan.wall_limit_s;
  WorkerPool pool(std::move(options));
  const auto require_unchanged = [&](std::size_t cell) {
    if (const auto changed = files.changed(cell)) {
      throw FileChanged(
          "'" + *changed +
          "' has changed since the batch began, and the runs would no longer belong to "
          "one experiment; restore it and continue with --resume, or start again with another "
          "--database");
    }
  };
  struct AtWork {
    std::size_t cell;
    Clock::time_point since;
  };
  std::map<std::int64_t, AtWork> at_work;                     // by run
  std::map<std::pair<std::size_t, int>, std::int64_t> alike;  // runs by cell and repetition
  for (const PlannedRun& run : pending) {
    ++alike[{run.cell, run.repetition}];
  }
  auto at = pending.begin();
  const auto next = [&]() -> std::optional<Job> {
    if (at == pending.end()) {
      return std::nullopt;
    }
    require_unchanged(at->cell);
    database.require_in_place();
    at_work[at->id] = {at->cell, Clock::now()};
    Job job = job_of(plan, *at);
    job.threads = threads;
    if (alike.at({at->cell, at->repetition}) < kFewestToShare) {
      job.cell.reset();
    }
    ++at;
    return job;
  };
  const auto ended = [&](std::int64_t run, const RunRecord& record) {
    const AtWork was = at_work.at(run);
    require_unchanged(was.cell);  // a file may have changed before the worker read it
    database.write(run, record);
    at_work.erase(run);
    estimate.add_ended(was.cell, seconds(Clock::now() - was.since));
    ++progress.ended;
    progress.failed += record.state == RunState::done ? 0 : 1;
  };
  const bool complete = pool.run(next, ended, [&] {
    progress.elapsed_s = seconds(Clock::now() - start);
    progress.left_s = estimate.left_s();
    if (watch) {
      watch(progress);
    }
  });
  database.require_in_place();
  return complete;
}

}  // namespace elsie::batch

#include "elsie/batch/batch.h"

#include <chrono>
#include <map>
#include <stdexcept>
#include <utility>

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

}  // namespace

bool carry_out(ResultsDatabase& database, PoolOptions options, std::size_t threads,
               const std::function<void(const Progress&)>& watch) {
  using Clock = std::chrono::steady_clock;
  const Plan& plan = database.plan();
  const std::vector<PlannedRun> pending = ordered(database);
  Progress progress{.runs = static_cast<std::int64_t>(pending.size())};
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
  std::map<std::int64_t, std::size_t> cells;                  // of the runs at work
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
    cells[at->id] = at->cell;
    Job job = job_of(plan, *at);
    job.threads = threads;
    if (alike.at({at->cell, at->repetition}) < kFewestToShare) {
      job.cell.reset();
    }
    ++at;
    return job;
  };
  const auto ended = [&](std::int64_t run, const RunRecord& record) {
    require_unchanged(cells.at(run));  // a file may have changed before the worker read it
    database.write(run, record);
    cells.erase(run);
    ++progress.ended;
    progress.failed += record.state == RunState::done ? 0 : 1;
  };
  const bool complete = pool.run(next, ended, [&] {
    progress.elapsed_s = std::chrono::duration<double>(Clock::now() - start).count();
    if (watch) {
      watch(progress);
    }
  });
  database.require_in_place();
  return complete;
}

}  // namespace elsie::batch

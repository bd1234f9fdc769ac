#include "elsie/batch/batch.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "elsie/batch/worker_pool.h"

namespace elsie::batch {

Job job_of(const Plan& plan, const PlannedRun& run) {
  const PlannedCell& cell = plan.cells[run.cell];
  Job job;
  job.run = run.id;
  const auto layout = cell.layouts.find(run.seed);
  job.world_text = layout == cell.layouts.end() ? cell.world_text : layout->second.world_text;
  job.world_file = cell.world_file;
  for (const PlannedCell::Data& data : cell.data) {
    job.files[data.name] = plan.files[data.file].path;
  }
  job.libraries = plan.libraries(cell);
  job.seed = run.seed;
  job.trajectory_period_s = plan.trajectory_period_s;
  return job;
}

bool carry_out(const Plan& plan, ResultsDatabase& database, const BatchOptions& options,
               const std::function<void(const Progress&)>& watch) {
  using Clock = std::chrono::steady_clock;
  const std::vector<std::int64_t> pending = database.pending();
  Progress progress{static_cast<std::int64_t>(pending.size()), 0, 0, 0.0};
  FileCheck files(plan);
  const auto start = Clock::now();
  WorkerPool pool({.command = options.worker,
                   .workers = options.workers,
                   .wall_limit_s = plan.wall_limit_s,
                   .stop_descriptor = options.stop_descriptor});
  const auto planned = [&](std::int64_t id) -> const PlannedRun& {
    const auto run = std::lower_bound(
        plan.runs.begin(), plan.runs.end(), id,
        [](const PlannedRun& other, std::int64_t number) { return other.id < number; });
    if (run == plan.runs.end() || run->id != id) {
      throw DatabaseError("run " + std::to_string(id) + " of the database '" +
                          database.file().string() + "' is not among those of the experiment");
    }
    return *run;
  };
  const auto require_unchanged = [&](const PlannedRun& run) {
    if (const auto changed = files.changed(run.cell)) {
      throw FileChanged(
          "'" + *changed +
          "' has changed since the batch began, and the runs would no longer belong to "
          "one experiment; restore it and continue with --resume, or start again with another "
          "--database");
    }
  };
  auto at = pending.begin();
  const auto next = [&]() -> std::optional<Job> {
    if (at == pending.end()) {
      return std::nullopt;
    }
    const PlannedRun& run = planned(*at);
    require_unchanged(run);
    database.require_in_place();
    ++at;
    return job_of(plan, run);
  };
  const auto ended = [&](std::int64_t run, const RunRecord& record) {
    require_unchanged(planned(run));  // a file may have changed before the worker read it
    database.write(run, record);
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

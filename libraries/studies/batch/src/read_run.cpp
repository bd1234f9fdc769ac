#include "read_run.h"

namespace elsie::batch {
namespace {

template <class Get>
auto value(const sqlite::Statement& query, int column, Get get) {
  return query.is_null(column) ? std::nullopt : std::optional(get(column));
}

void read_data(sqlite::Connection& connection, std::int64_t cell, StoredRun& run) {
  sqlite::Statement query(connection,
                          "SELECT name, path, sha256, content FROM cell_files JOIN files ON "
                          "files.id = file_id WHERE cell_id = ? ORDER BY name");
  query.bind(1, cell);
  while (query.next()) {
    run.data.push_back({query.text(0), query.text(1), query.text(2), query.text(3)});
  }
}

void read_libraries(sqlite::Connection& connection, std::int64_t cell, StoredRun& run) {
  sqlite::Statement query(connection,
                          "SELECT path, sha256, plugins.kind || ' ' || name || ' ' || version "
                          "FROM cell_plugins JOIN plugins ON plugins.id = plugin_id JOIN files ON "
                          "files.id = file_id WHERE cell_id = ? ORDER BY load_order, path, name");
  query.bind(1, cell);
  while (query.next()) {
    if (run.libraries.empty() || run.libraries.back().path != query.text(0)) {
      run.libraries.push_back({query.text(0), query.text(1), {}});
    }
    run.libraries.back().plugins.push_back(query.text(2));
  }
  sqlite::Statement own(
      connection,
      "SELECT path, sha256 FROM files WHERE kind = 'library' AND load_order IS "
      "NULL AND id NOT IN (SELECT file_id FROM plugins WHERE file_id IS NOT NULL) "
      "ORDER BY id");
  while (own.next()) {
    run.program.push_back({own.text(0), own.text(1), {}});
  }
}

void read_measures(sqlite::Connection& connection, StoredRun& run) {
  sqlite::Statement query(connection,
                          "SELECT name, unit, meaning, value FROM run_measures JOIN measures ON "
                          "measures.name = measure WHERE run_id = ? ORDER BY name");
  query.bind(1, run.job.run);
  while (query.next()) {
    run.record.measures.push_back(
        {query.text(0), query.text(1), query.text(2),
         value(query, 3, [&](int column) { return query.number(column); })});
  }
}

}  // namespace

std::optional<StoredRun> read_run(sqlite::Connection& connection, std::int64_t id) {
  sqlite::Statement query(
      connection,
      "SELECT cells.id, label, world_text, world_file, seed, repetition, state, outcome, message, "
      "steps, simulated_s, state_hash, signal, plugin, robot, step, elsie_version, wall_limit_s, "
      "trajectory_period_s, experiment, solver_gave_up, solver_unsolved FROM runs JOIN cells ON "
      "cells.id = runs.cell_id JOIN about "
      "WHERE runs.id = ?");
  query.bind(1, id);
  if (!query.next()) {
    return std::nullopt;
  }
  const auto text = [&](int column) { return query.text(column); };
  const auto count = [&](int column) { return static_cast<std::uint64_t>(query.integer(column)); };
  const auto number = [&](int column) { return query.number(column); };
  StoredRun run;
  run.cell = query.text(1);
  run.job.run = id;
  run.job.world_text = query.text(2);
  run.job.world_file = query.text(3);
  run.job.seed = count(4);
  run.repetition = static_cast<int>(query.integer(5));
  run.record.state = results::run_state(query.text(6));
  run.record.outcome = value(query, 7, text);
  run.record.message = query.text(8);
  run.record.steps = value(query, 9, count);
  run.record.simulated_s = value(query, 10, number);
  run.record.state_hash = value(query, 11, text);
  run.record.signal = value(query, 12, text);
  run.record.plugin = value(query, 13, text);
  run.record.robot = value(query, 14, text);
  run.record.step = value(query, 15, count);
  run.elsie_version = query.text(16);
  run.wall_limit_s = query.number(17);
  run.job.trajectory_period_s = query.number(18);
  run.experiment = query.text(19);
  run.record.solver_gave_up = value(query, 20, count);
  run.record.solver_unsolved = value(query, 21, count);
  const std::int64_t cell = query.integer(0);
  read_data(connection, cell, run);
  read_libraries(connection, cell, run);
  read_measures(connection, run);
  return run;
}

}  // namespace elsie::batch

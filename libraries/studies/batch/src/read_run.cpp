#include "read_run.h"

namespace elsie::batch {
namespace {

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
        {query.text(0), query.text(1), query.text(2), query.optional_number(3)});
  }
}

}  // namespace

std::optional<StoredRun> read_run(sqlite::Connection& connection, std::int64_t id) {
  sqlite::Statement query(
      connection,
      "SELECT cells.id, label, run_worlds.world_text, world_file, seed, repetition, elsie_version, "
      "wall_limit_s, trajectory_period_s, experiment, " +
          results::field_names() +
          " FROM runs JOIN cells ON cells.id = runs.cell_id JOIN run_worlds ON run_id = runs.id "
          "JOIN about WHERE runs.id = ?");
  query.bind(1, id);
  if (!query.next()) {
    return std::nullopt;
  }
  StoredRun run;
  run.cell = query.text(1);
  run.job.run = id;
  run.job.world_text = query.text(2);
  run.job.world_file = query.text(3);
  run.job.seed = static_cast<std::uint64_t>(query.integer(4));
  run.repetition = static_cast<int>(query.integer(5));
  run.elsie_version = query.text(6);
  run.wall_limit_s = query.number(7);
  run.job.trajectory_period_s = query.number(8);
  run.experiment = query.text(9);
  results::read_fields(query, 10, run.record);
  const std::int64_t cell = query.integer(0);
  read_data(connection, cell, run);
  read_libraries(connection, cell, run);
  read_measures(connection, run);
  return run;
}

}  // namespace elsie::batch

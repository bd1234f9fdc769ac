#include "write_plan.h"

#include <chrono>
#include <ctime>

#include "elsie/results/database_file.h"

namespace elsie::batch {
namespace {

/// Row numbers are indices into lists.
std::int64_t id(std::size_t place) { return static_cast<std::int64_t>(place); }

void write_about(sqlite::Connection& connection, const Plan& plan) {
  sqlite::Statement(connection,
                    "INSERT INTO about (id, elsie_version, abi, experiment, description, file, "
                    "text, fingerprint, shard, runs, wall_limit_s, trajectory_period_s, created) "
                    "VALUES (1, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .bind(1, plan.elsie_version)
      .bind(2, plan.abi)
      .bind(3, plan.experiment)
      .bind(4, plan.description)
      .bind(5, plan.file)
      .bind(6, plan.text)
      .bind(7, plan.fingerprint)
      .bind(8, plan.shard.text())
      .bind(9, plan.all_runs)
      .bind(10, plan.wall_limit_s)
      .bind(11, plan.trajectory_period_s)
      .bind(12, utc_now())
      .run();
}

void write_files(sqlite::Connection& connection, const Plan& plan) {
  sqlite::Statement insert(connection,
                           "INSERT INTO files (id, kind, path, sha256, content, load_order) "
                           "VALUES (?, ?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < plan.files.size(); ++i) {
    const PlannedFile& file = plan.files[i];
    insert.bind(1, id(i)).bind(2, to_string(file.kind)).bind(3, file.path).bind(4, file.sha256);
    file.kind == FileKind::data ? insert.bind_bytes(5, file.content) : insert.bind_null(5);
    file.kind == FileKind::library&& file.rank > 0 ? insert.bind(6, id(file.rank))
                                                   : insert.bind_null(6);
    insert.run();
  }
}

void write_plugins(sqlite::Connection& connection, const Plan& plan) {
  sqlite::Statement insert(connection,
                           "INSERT INTO plugins (id, kind, name, version, file_id) "
                           "VALUES (?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < plan.plugins.size(); ++i) {
    const PlannedPlugin& plugin = plan.plugins[i];
    insert.bind(1, id(i)).bind(2, plugin.kind).bind(3, plugin.name).bind(4, plugin.version);
    plugin.file ? insert.bind(5, id(*plugin.file)) : insert.bind_null(5);
    insert.run();
  }
}

void write_cells(sqlite::Connection& connection, const Plan& plan) {
  sqlite::Statement cell(connection,
                         "INSERT INTO cells (id, label, world, world_text, world_file, sha256, "
                         "layout_seed) VALUES (?, ?, ?, ?, ?, ?, ?)");
  sqlite::Statement layout(connection,
                           "INSERT INTO layouts (cell_id, seed, world_text, sha256) "
                           "VALUES (?, ?, ?, ?)");
  sqlite::Statement level(connection,
                          "INSERT INTO cell_levels (cell_id, factor_id, label, place) "
                          "VALUES (?, ?, ?, ?)");
  sqlite::Statement plugin(connection,
                           "INSERT INTO cell_plugins (cell_id, plugin_id) VALUES (?, ?)");
  sqlite::Statement data(connection,
                         "INSERT INTO cell_files (cell_id, file_id, name) VALUES (?, ?, ?)");
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    const PlannedCell& planned = plan.cells[i];
    cell.bind(1, id(i))
        .bind(2, planned.label)
        .bind(3, planned.world)
        .bind(4, planned.world_text)
        .bind(5, planned.world_file)
        .bind(6, planned.sha256);
    planned.layout_seed ? cell.bind(7, static_cast<std::int64_t>(*planned.layout_seed))
                        : cell.bind_null(7);
    cell.run();
    for (const auto& [seed, drawn] : planned.layouts) {
      layout.bind(1, id(i))
          .bind(2, static_cast<std::int64_t>(seed))
          .bind(3, drawn.world_text)
          .bind(4, drawn.sha256)
          .run();
    }
    for (const PlannedLevel& of : planned.levels) {
      level.bind(1, id(i)).bind(2, id(of.factor)).bind(3, of.label).bind(4, id(of.place)).run();
    }
    for (const std::size_t used : planned.plugins) {
      plugin.bind(1, id(i)).bind(2, id(used)).run();
    }
    for (const PlannedCell::Data& used : planned.data) {
      data.bind(1, id(i)).bind(2, id(used.file)).bind(3, used.name).run();
    }
  }
}

}  // namespace

std::string utc_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  return {text, std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

void write_plan(sqlite::Connection& connection, const Plan& plan) {
  results::make_schema(connection);
  write_about(connection, plan);
  sqlite::Statement factor(connection, "INSERT INTO factors (id, name) VALUES (?, ?)");
  for (std::size_t i = 0; i < plan.factors.size(); ++i) {
    factor.bind(1, id(i)).bind(2, plan.factors[i]).run();
  }
  write_files(connection, plan);
  write_plugins(connection, plan);
  write_cells(connection, plan);
}

void add_runs(sqlite::Connection& connection, const Plan& plan) {
  sqlite::Statement insert(connection,
                           "INSERT OR IGNORE INTO runs (id, cell_id, seed, repetition) "
                           "VALUES (?, ?, ?, ?)");
  for (const PlannedRun& run : plan.runs) {
    insert.bind(1, run.id)
        .bind(2, id(run.cell))
        .bind(3, static_cast<std::int64_t>(run.seed))
        .bind(4, std::int64_t{run.repetition})
        .run();
  }
}

}  // namespace elsie::batch

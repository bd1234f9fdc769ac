#include "write_plan.h"

#include <chrono>
#include <ctime>
#include <optional>
#include <vector>

#include "elsie/results/database_file.h"

#include "stages.h"

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

/// The first column of the only row; none: there is no row.
std::optional<std::int64_t> found(sqlite::Statement& query) {
  std::optional<std::int64_t> result;
  while (query.next()) {
    result = query.integer(0);
  }
  return result;
}

/// Writes the files that are not there yet. Returns the ids of all.
std::vector<std::int64_t> write_files(sqlite::Connection& connection, const Plan& plan) {
  std::int64_t next = connection.integer("SELECT coalesce(max(id) + 1, 0) FROM files");
  sqlite::Statement known(connection, "SELECT id FROM files WHERE path = ?");
  sqlite::Statement insert(connection,
                           "INSERT INTO files (id, kind, path, sha256, content, load_order) "
                           "VALUES (?, ?, ?, ?, ?, ?)");
  sqlite::Statement becomes_data(connection,
                                 "UPDATE files SET kind = 'data', sha256 = ?, content = ? "
                                 "WHERE id = ? AND kind = 'world'");
  std::vector<std::int64_t> ids;
  for (const PlannedFile& file : plan.files) {
    if (const auto before = found(known.bind(1, file.path))) {
      ids.push_back(*before);
      if (file.kind == FileKind::data) {
        becomes_data.bind(1, file.sha256).bind_bytes(2, file.content).bind(3, *before).run();
      }
      continue;
    }
    insert.bind(1, next).bind(2, to_string(file.kind)).bind(3, file.path).bind(4, file.sha256);
    file.kind == FileKind::data ? insert.bind_bytes(5, file.content) : insert.bind_null(5);
    file.kind == FileKind::library&& file.rank > 0 ? insert.bind(6, id(file.rank))
                                                   : insert.bind_null(6);
    insert.run();
    ids.push_back(next++);
  }
  return ids;
}

/// Writes the plugins that are not there yet. Returns the ids of all.
std::vector<std::int64_t> write_plugins(sqlite::Connection& connection, const Plan& plan,
                                        const std::vector<std::int64_t>& files) {
  std::int64_t next = connection.integer("SELECT coalesce(max(id) + 1, 0) FROM plugins");
  sqlite::Statement known(connection, "SELECT id FROM plugins WHERE kind = ? AND name = ?");
  sqlite::Statement insert(connection,
                           "INSERT INTO plugins (id, kind, name, version, file_id) "
                           "VALUES (?, ?, ?, ?, ?)");
  std::vector<std::int64_t> ids;
  for (const PlannedPlugin& plugin : plan.plugins) {
    if (const auto before = found(known.bind(1, plugin.kind).bind(2, plugin.name))) {
      ids.push_back(*before);
      continue;
    }
    insert.bind(1, next).bind(2, plugin.kind).bind(3, plugin.name).bind(4, plugin.version);
    plugin.file ? insert.bind(5, files[*plugin.file]) : insert.bind_null(5);
    insert.run();
    ids.push_back(next++);
  }
  return ids;
}

/// Writes the cells from the `first` on.
void write_cells(sqlite::Connection& connection, const Plan& plan, std::size_t first,
                 const std::vector<std::int64_t>& files, const std::vector<std::int64_t>& plugins) {
  sqlite::Statement cell(
      connection,
      "INSERT INTO cells (id, label, world, world_text, world_file, sha256, place, layout_seed) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
  sqlite::Statement level(connection,
                          "INSERT INTO cell_levels (cell_id, factor_id, label, place) "
                          "VALUES (?, ?, ?, ?)");
  sqlite::Statement plugin(connection,
                           "INSERT INTO cell_plugins (cell_id, plugin_id) VALUES (?, ?)");
  sqlite::Statement data(connection,
                         "INSERT INTO cell_files (cell_id, file_id, name) VALUES (?, ?, ?)");
  for (std::size_t i = first; i < plan.cells.size(); ++i) {
    const PlannedCell& planned = plan.cells[i];
    cell.bind(1, id(i))
        .bind(2, planned.label)
        .bind(3, planned.world)
        .bind(4, planned.world_text)
        .bind(5, planned.world_file)
        .bind(6, planned.sha256)
        .bind(7, id(planned.place));
    planned.layout_seed ? cell.bind(8, static_cast<std::int64_t>(*planned.layout_seed))
                        : cell.bind_null(8);
    cell.run();
    for (const PlannedLevel& of : planned.levels) {
      level.bind(1, id(i)).bind(2, id(of.factor)).bind(3, of.label).bind(4, id(of.place)).run();
    }
    for (const std::size_t used : planned.plugins) {
      plugin.bind(1, id(i)).bind(2, plugins[used]).run();
    }
    for (const PlannedCell::Data& used : planned.data) {
      data.bind(1, id(i)).bind(2, files[used.file]).bind(3, used.name).run();
    }
  }
}

/// Writes the layouts that are not there yet, those of new seeds in old cells among them.
void write_layouts(sqlite::Connection& connection, const Plan& plan) {
  sqlite::Statement insert(connection,
                           "INSERT OR IGNORE INTO layouts (cell_id, seed, world_text, sha256) "
                           "VALUES (?, ?, ?, ?)");
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    for (const auto& [seed, layout] : plan.cells[i].layouts) {
      insert.bind(1, id(i))
          .bind(2, static_cast<std::int64_t>(seed))
          .bind(3, layout.world_text)
          .bind(4, layout.sha256)
          .run();
    }
  }
}

/// Cells keep their numbers, but their labels name a factor only when it has several levels, and
/// new levels may come between the old ones.
void rename_cells(sqlite::Connection& connection, const Plan& plan, std::size_t count) {
  sqlite::Statement cell(connection, "UPDATE cells SET label = ?, place = ? WHERE id = ?");
  sqlite::Statement level(connection,
                          "UPDATE cell_levels SET place = ? WHERE cell_id = ? AND factor_id = ?");
  for (std::size_t i = 0; i < count; ++i) {
    const PlannedCell& planned = plan.cells[i];
    cell.bind(1, planned.label).bind(2, id(planned.place)).bind(3, id(i)).run();
    for (const PlannedLevel& of : planned.levels) {
      level.bind(1, id(of.place)).bind(2, id(i)).bind(3, id(of.factor)).run();
    }
  }
}

/// Everything that stages from the `first` on add, but their runs.
void write_stages(sqlite::Connection& connection, const Plan& plan, std::size_t first) {
  const std::size_t cells_before = first > 0 ? plan.stages[first - 1].cells : 0;
  const std::vector<std::int64_t> files = write_files(connection, plan);
  const std::vector<std::int64_t> plugins = write_plugins(connection, plan, files);
  rename_cells(connection, plan, cells_before);
  write_cells(connection, plan, cells_before, files, plugins);
  write_layouts(connection, plan);
  sqlite::Statement insert(connection,
                           "INSERT INTO stages (id, cells, seeds, repeats, runs, fingerprint, "
                           "created) VALUES (?, ?, ?, ?, ?, ?, ?)");
  for (std::size_t i = first; i < plan.stages.size(); ++i) {
    const Stage& stage = plan.stages[i];
    insert.bind(1, id(i))
        .bind(2, id(stage.cells))
        .bind(3, seeds_text(stage.seeds))
        .bind(4, std::int64_t{stage.repeats})
        .bind(5, stage.runs)
        .bind(6, stage.fingerprint)
        .bind(7, utc_now())
        .run();
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
  write_stages(connection, plan, 0);
}

void renew_plan(sqlite::Connection& connection, const Plan& plan, std::size_t known_stages) {
  if (plan.stages.size() > known_stages) {
    write_stages(connection, plan, known_stages);
  }
  sqlite::Statement(connection,
                    "UPDATE about SET experiment = ?, description = ?, text = ?, "
                    "wall_limit_s = ?, fingerprint = ?, runs = ?")
      .bind(1, plan.experiment)
      .bind(2, plan.description)
      .bind(3, plan.text)
      .bind(4, plan.wall_limit_s)
      .bind(5, plan.fingerprint)
      .bind(6, plan.all_runs)
      .run();
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

#include "write_plan.h"

#include <chrono>
#include <ctime>
#include <optional>
#include <vector>

#include "elsie/results/database_file.h"

#include "stages.h"

namespace elsie::batch {
namespace {

void write_about(sqlite::Connection& connection, const Plan& plan) {
  sqlite::Statement::insert(connection, "about",
                            "id, elsie_version, abi, experiment, description, file, text, "
                            "fingerprint, shard, runs, wall_limit_s, trajectory_period_s, created")
      .run(1, plan.elsie_version, plan.abi, plan.experiment, plan.description, plan.file, plan.text,
           plan.fingerprint, plan.shard.text(), plan.all_runs, plan.wall_limit_s,
           plan.trajectory_period_s, utc_now());
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
  auto insert =
      sqlite::Statement::insert(connection, "files", "id, kind, path, sha256, content, load_order");
  sqlite::Statement becomes_data(connection,
                                 "UPDATE files SET kind = 'data', sha256 = ?, content = ? "
                                 "WHERE id = ? AND kind = 'world'");
  std::vector<std::int64_t> ids;
  for (const PlannedFile& file : plan.files) {
    if (const auto before = found(known.bind(1, file.path))) {
      ids.push_back(*before);
      if (file.kind == FileKind::data) {
        becomes_data.run(file.sha256, sqlite::Bytes{file.content}, *before);
      }
      continue;
    }
    std::optional<sqlite::Bytes> content;
    if (file.kind == FileKind::data) content = {file.content};
    std::optional<std::size_t> load_order;
    if (file.kind == FileKind::library && file.rank > 0) load_order = file.rank;
    insert.run(next, to_string(file.kind), file.path, file.sha256, content, load_order);
    ids.push_back(next++);
  }
  return ids;
}

/// Writes the plugins that are not there yet. Returns the ids of all.
std::vector<std::int64_t> write_plugins(sqlite::Connection& connection, const Plan& plan,
                                        const std::vector<std::int64_t>& files) {
  std::int64_t next = connection.integer("SELECT coalesce(max(id) + 1, 0) FROM plugins");
  sqlite::Statement known(connection, "SELECT id FROM plugins WHERE kind = ? AND name = ?");
  auto insert =
      sqlite::Statement::insert(connection, "plugins", "id, kind, name, version, file_id");
  std::vector<std::int64_t> ids;
  for (const PlannedPlugin& plugin : plan.plugins) {
    if (const auto before = found(known.bind(1, plugin.kind).bind(2, plugin.name))) {
      ids.push_back(*before);
      continue;
    }
    insert.run(next, plugin.kind, plugin.name, plugin.version,
               plugin.file ? std::optional(files[*plugin.file]) : std::nullopt);
    ids.push_back(next++);
  }
  return ids;
}

/// Writes the cells from the `first` on.
void write_cells(sqlite::Connection& connection, const Plan& plan, std::size_t first,
                 const std::vector<std::int64_t>& files, const std::vector<std::int64_t>& plugins) {
  auto cell = sqlite::Statement::insert(
      connection, "cells", "id, label, world, world_text, world_file, sha256, place, layout_seed");
  auto level =
      sqlite::Statement::insert(connection, "cell_levels", "cell_id, factor_id, label, place");
  auto plugin = sqlite::Statement::insert(connection, "cell_plugins", "cell_id, plugin_id");
  auto data = sqlite::Statement::insert(connection, "cell_files", "cell_id, file_id, name");
  for (std::size_t i = first; i < plan.cells.size(); ++i) {
    const PlannedCell& planned = plan.cells[i];
    cell.run(i, planned.label, planned.world, planned.world_text, planned.world_file,
             planned.sha256, planned.place, planned.layout_seed);
    for (std::size_t factor = 0; factor < planned.levels.size(); ++factor) {
      level.run(i, factor, planned.levels[factor], planned.places[factor]);
    }
    for (const std::size_t used : planned.plugins) {
      plugin.run(i, plugins[used]);
    }
    for (const PlannedCell::Data& used : planned.data) {
      data.run(i, files[used.file], used.name);
    }
  }
}

/// Writes the layouts that are not there yet, those of new seeds in old cells among them.
void write_layouts(sqlite::Connection& connection, const Plan& plan) {
  auto insert = sqlite::Statement::insert_or_ignore(connection, "layouts",
                                                    "cell_id, seed, world_text, sha256");
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    for (const auto& [seed, layout] : plan.cells[i].layouts) {
      insert.run(i, seed, layout.world_text, layout.sha256);
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
    cell.run(planned.label, planned.place, i);
    for (std::size_t factor = 0; factor < planned.places.size(); ++factor) {
      level.run(planned.places[factor], i, factor);
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
  auto insert = sqlite::Statement::insert(connection, "stages",
                                          "id, cells, seeds, repeats, runs, fingerprint, created");
  for (std::size_t i = first; i < plan.stages.size(); ++i) {
    const Stage& stage = plan.stages[i];
    insert.run(i, stage.cells, seeds_text(stage.seeds), stage.repeats, stage.runs,
               stage.fingerprint, utc_now());
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
  auto factor = sqlite::Statement::insert(connection, "factors", "id, name");
  for (std::size_t i = 0; i < plan.factors.size(); ++i) {
    factor.run(i, plan.factors[i]);
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
      .run(plan.experiment, plan.description, plan.text, plan.wall_limit_s, plan.fingerprint,
           plan.all_runs);
}

void add_runs(sqlite::Connection& connection, const Plan& plan) {
  auto insert =
      sqlite::Statement::insert_or_ignore(connection, "runs", "id, cell_id, seed, repetition");
  for (const PlannedRun& run : plan.runs) {
    insert.run(run.id, run.cell, run.seed, run.repetition);
  }
}

}  // namespace elsie::batch

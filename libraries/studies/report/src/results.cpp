#include "elsie/report/results.h"

#include <map>
#include <utility>

#include "elsie/base/random.h"

#include "results_state.h"

namespace elsie::report {

namespace {

void read_about(sqlite::Connection& connection, Results& results) {
  sqlite::Statement about(
      connection,
      "SELECT elsie_version, experiment, description, file, text, fingerprint, shard, "
      "created, runs FROM about");
  about.next();
  int column = 0;
  for (std::string* text :
       {&results.elsie_version, &results.experiment, &results.description, &results.file,
        &results.text, &results.fingerprint, &results.shard, &results.created}) {
    *text = about.text(column++);
  }
  results.all_runs = static_cast<std::size_t>(about.integer(column));
}

using Places = std::map<std::int64_t, std::size_t>;  // ids to indices

Places read_factors(sqlite::Connection& connection, Results& results) {
  Places places;
  sqlite::Statement factors(connection, "SELECT id, name FROM factors ORDER BY id");
  while (factors.next()) {
    places[factors.integer(0)] = results.factors.size();
    results.factors.push_back({factors.text(1)});
  }
  return places;
}

Places read_cells(sqlite::Connection& connection, Results& results) {
  const Places factors = read_factors(connection, results);
  Places places;
  sqlite::Statement cells(connection,
                          "SELECT id, label, world, cells.world_text, world_file, seed FROM cells "
                          "LEFT JOIN layouts ON cell_id = id AND layouts.sha256 = cells.sha256 "
                          "GROUP BY id ORDER BY place, id");
  while (cells.next()) {
    CellInfo cell;
    cell.id = cells.integer(0);
    cell.label = cells.text(1);
    cell.world = cells.text(2);
    cell.world_text = cells.text(3);
    cell.world_file = cells.text(4);
    if (!cells.is_null(5)) cell.seed = static_cast<std::uint64_t>(cells.integer(5));
    cell.levels.resize(results.factors.size());
    cell.places.resize(results.factors.size());
    places[cell.id] = results.cells.size();
    results.cells.push_back(std::move(cell));
  }
  sqlite::Statement levels(connection, "SELECT cell_id, factor_id, label, place FROM cell_levels");
  while (levels.next()) {
    CellInfo& cell = results.cells[places.at(levels.integer(0))];
    const std::size_t factor = factors.at(levels.integer(1));
    cell.levels[factor] = levels.text(2);
    cell.places[factor] = static_cast<int>(levels.integer(3));
  }
  return places;
}

// The most important measures come first, the others by name.
std::map<std::string, std::size_t> read_measures(sqlite::Connection& connection, Results& results) {
  std::map<std::string, std::size_t> places;
  sqlite::Statement measures(
      connection,
      "SELECT name, unit, meaning FROM measures ORDER BY CASE name WHEN 'success' THEN "
      "0 WHEN 'path_length_m' THEN 1 WHEN 'time_s' THEN 2 ELSE 3 END, name");
  while (measures.next()) {
    places[measures.text(0)] = results.measures.size();
    results.measures.push_back({measures.text(0), measures.text(1), measures.text(2)});
  }
  return places;
}

void read_runs(sqlite::Connection& connection, const Places& cells, Results& results) {
  const auto measures = read_measures(connection, results);
  Places places;
  sqlite::Statement runs(connection, "SELECT id, cell_id, seed, repetition, " +
                                         results::field_names() + " FROM runs ORDER BY id");
  while (runs.next()) {
    Run run;
    run.id = runs.integer(0);
    run.cell = cells.at(runs.integer(1));
    run.seed = static_cast<std::uint64_t>(runs.integer(2));
    run.repetition = static_cast<int>(runs.integer(3));
    results::read_fields(runs, 4, run);
    run.values.resize(results.measures.size());
    places[run.id] = results.runs.size();
    results.runs.push_back(std::move(run));
  }
  sqlite::Statement robots(connection, "SELECT run_id, count(*) FROM run_robots GROUP BY run_id");
  while (robots.next()) {
    results.runs[places.at(robots.integer(0))].robots = robots.number(1);
  }
  sqlite::Statement values(connection, "SELECT run_id, measure, value FROM run_measures");
  while (values.next()) {
    Run& run = results.runs[places.at(values.integer(0))];
    run.values[measures.at(values.text(1))] = values.optional_number(2);
  }
}

}  // namespace

std::uint64_t Results::seed() const { return Random(0, fingerprint).bits(); }

ResultsFile::ResultsFile(const std::filesystem::path& file)
    : state_(std::make_unique<State>(file)) {
  // A transaction begins with its first read, and does not see later writes.
  state_->reading([&] { state_->connection.run("BEGIN; SELECT count(*) FROM about"); });
}

ResultsFile::~ResultsFile() = default;

Results ResultsFile::results() const {
  return state_->reading([&] {
    Results results;
    read_about(state_->connection, results);
    const Places cells = read_cells(state_->connection, results);
    read_runs(state_->connection, cells, results);
    return results;
  });
}

}  // namespace elsie::report

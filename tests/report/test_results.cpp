// Reading a results database.
#include <filesystem>

#include <catch2/catch.hpp>
#include <sqlite3.h>

#include "elsie/results/database_file.h"

#include "fixture.h"

using namespace elsie::report;
using Catch::Contains;
using namespace elsie::test;

namespace {

void run(const std::filesystem::path& file, const std::string& sql) {
  sqlite3* handle = nullptr;
  REQUIRE(sqlite3_open(file.c_str(), &handle) == SQLITE_OK);
  REQUIRE(sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK);
  REQUIRE(sqlite3_close(handle) == SQLITE_OK);
}

std::string refusal(const std::filesystem::path& file) {
  try {
    const ResultsFile results(file);
    results.results();
  } catch (const elsie::results::DatabaseRefused& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("A database is read as it was written") {
  const Made made(elsie::test::made_study());
  const ResultsFile file(made.path);
  const Results results = file.results();
  CHECK(results.experiment == "Coordination by neural networks");
  CHECK(results.cells.size() == 8);
  CHECK(results.runs.size() == 160);
  CHECK(results.factors.size() == 3);
  CHECK(results.cells[3].levels == std::vector<std::string>{"four_resources", "4 4", "fusion"});
  CHECK(results.cells[3].places == std::vector<int>{0, 1, 1});
  const Run& crash = results.runs[51];
  CHECK(crash.state == RunState::crash);
  CHECK(crash.signal == "SIGSEGV");
  CHECK(crash.step == 8123);
  CHECK_FALSE(crash.outcome);
  const auto ways = file.trajectories(results.cells[0].id);
  REQUIRE(ways.size() == 20);
  CHECK(ways[0].robot == "collector");
  CHECK(ways[0].period_s == 0.5);
  CHECK(ways[0].poses.size() > 100);
  CHECK(file.timelines(results.cells[0].id)[0].behaviors[0].path == "find_resource");
  CHECK(file.curves(results.cells[0].id)[0].points.size() == 201);
}

TEST_CASE("A way ends at the robot's pose at the end of the run, even between two samples") {
  elsie::test::MadeExperiment made_up = elsie::test::made_from({{1, 2}});
  for (auto& run : made_up.cells[0].runs) {
    run.robots.resize(1);
    run.robots[0].poses = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
  }
  made_up.cells[0].runs[0].robots[0].end = elsie::Pose{1.25, 0.5, 0.1};
  const Made made(made_up);
  const ResultsFile file(made.path);
  const auto ways = file.trajectories(file.results().cells[0].id);
  REQUIRE(ways.size() == 2);
  REQUIRE(ways[0].poses.size() == 3);
  CHECK(ways[0].poses.back().x == 1.25);
  CHECK(ways[0].poses.back().y == 0.5);
  CHECK(ways[1].poses.size() == 2);  // a failed run has no such pose
}

TEST_CASE("Files that are no results database, or a damaged one, are refused in a sentence") {
  const Made made(made_from({{1, 2}}));
  std::string why = "the database '" + made.path.string() + "'";
  SECTION("another version") {
    run(made.path, "PRAGMA user_version = 7");
    CHECK_THAT(refusal(made.path), Contains(why + " has version 7 of the schema"));
  }
  SECTION("no plan") {
    run(made.path, "DELETE FROM about");
    CHECK_THAT(refusal(made.path), Contains(why + " was not begun"));
  }
  SECTION("rows with missing references") {
    run(made.path, "PRAGMA foreign_keys = OFF; DELETE FROM cells WHERE id = 0");
    CHECK_THAT(refusal(made.path), Contains(why + " is damaged"));
  }
  SECTION("a text that is a list at its ends only") {
    run(made.path, "UPDATE trajectories SET poses = '[[1, 2]'");
    CHECK_THAT(refusal(made.path), Contains(why + " is damaged") && Contains("trajectories"));
  }
}

TEST_CASE("Later writes are not seen while it is read") {
  const Made made(made_from({{1, 2}}));
  run(made.path, "PRAGMA journal_mode = WAL");
  const ResultsFile file(made.path);
  run(made.path, "UPDATE about SET experiment = 'another'");
  CHECK(file.results().experiment == "made up");
  CHECK(ResultsFile(made.path).results().experiment == "another");
}

TEST_CASE("Poses that are not finite are gaps") {
  const Made made(made_from({{1, 2}}));
  run(made.path,
      "UPDATE trajectories SET poses = '[[0,0,0],[1,0,0],[null,null,0],[3,0,0],[4,0,0]]'");
  const ResultsFile file(made.path);
  CHECK(std::isnan(file.trajectories(0)[0].poses[2].x));
  CHECK_THAT(html_report(find(file.results(), {}), file, "r.db"), Contains("M"));
}

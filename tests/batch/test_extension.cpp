// Databases whose experiment grows: seeds, repetitions, levels and worlds that come later.
#include <filesystem>
#include <set>

#include <catch2/catch.hpp>

#include "elsie/batch/merge.h"
#include "elsie/batch/results_database.h"

#include "support.h"
#include "tables.h"

using namespace elsie;
using batch::ResultsDatabase;
using Catch::Contains;
using test::plan_of;
namespace fs = std::filesystem;

namespace {

using Experiment = experiment::Experiment;

void add_level(Experiment& experiment, const std::string& label, const std::string& speed,
               std::ptrdiff_t place) {
  auto& levels = experiment.factors[0].levels;
  levels.insert(levels.begin() + place,
                {label, {test::setting("robot[r1]/@max_speed", speed)}, {}});
}

/// A record that tells which run it is of.
batch::RunRecord record_of(std::int64_t run) {
  return test::some_record(simulation::hash_text(static_cast<std::uint64_t>(run)));
}

void do_all(ResultsDatabase& database) {
  for (const std::int64_t run : database.pending()) {
    database.write(run, record_of(run));
  }
}

std::string runs_in(const std::string& file) {
  return test::rows(file,
                    "SELECT runs.id, label, seed, repetition, state_hash FROM runs JOIN cells ON "
                    "cells.id = cell_id ORDER BY runs.id");
}

/// A folder with a database of the small experiment, all of whose runs are done.
struct Begun {
  test::Folder folder;
  std::string file = folder.file("r.sqlite");
  Experiment experiment = test::small_experiment(folder);

  Begun() {
    auto database = ResultsDatabase::create(file, plan_of(experiment));
    do_all(database);
  }
};

}  // namespace

TEST_CASE("Seeds that are added come after the runs that exist, which keep their numbers") {
  Begun begun;
  const std::string before = runs_in(begun.file);
  begun.experiment.seeds.insert(begun.experiment.seeds.begin(), 7);
  begun.experiment.seeds.push_back(9);
  {
    auto database = ResultsDatabase::extend(begun.file, plan_of(begun.experiment));
    CHECK(database.added_runs() == 4);
    CHECK(database.pending() == std::vector<std::int64_t>{7, 8, 9, 10});
    CHECK(database.plan().all_runs == 10);
    CHECK(database.seeds().all == 5);
    CHECK(database.seeds().complete == 3);
    do_all(database);
  }
  CHECK(runs_in(begun.file) == before +
                                   "7|slow|7|1|0000000000000007\n8|slow|9|1|0000000000000008\n"
                                   "9|fast|7|1|0000000000000009\n10|fast|9|1|000000000000000a\n");
  CHECK(test::rows(begun.file, "SELECT id, cells, seeds, repeats, runs FROM stages ORDER BY id") ==
        "0|2|1-2,18446744073709551615|1|6\n1|2|7,1-2,18446744073709551615,9|1|10\n");
  CHECK(test::rows(begun.file, "SELECT runs FROM about") == "10\n");
  CHECK(test::rows(begun.file, "PRAGMA integrity_check") == "ok\n");
  CHECK(test::rows(begun.file, "PRAGMA foreign_key_check").empty());
  // It is resumed by the larger experiment from now on, and extended once only.
  CHECK(ResultsDatabase::resume(begun.file, plan_of(begun.experiment)).pending().empty());
  CHECK(ResultsDatabase::extend(begun.file, plan_of(begun.experiment)).added_runs() == 0);
}

TEST_CASE("Levels, worlds and repetitions may be added, one after another and at once") {
  Begun begun;
  add_level(begun.experiment, "middling", "0.2", 1);
  {
    auto database = ResultsDatabase::extend(begun.file, plan_of(begun.experiment));
    CHECK(database.pending() == std::vector<std::int64_t>{7, 8, 9});
    do_all(database);
    const auto cells = database.cells();
    REQUIRE(cells.size() == 3);
    CHECK(cells[1].label == "middling");  // where the experiment has it
  }
  CHECK(test::rows(begun.file, "SELECT id, label, place FROM cells ORDER BY id") ==
        "0|slow|0\n1|fast|2\n2|middling|1\n");
  CHECK(test::rows(begun.file,
                   "SELECT cell_id, label, place FROM cell_levels WHERE factor_id = 1 ORDER BY "
                   "1") == "0|slow|0\n1|fast|2\n2|middling|1\n");

  // Another world changes the names of all cells.
  const std::string world = begun.folder.write(
      "other.xml", std::string(test::kWorld).replace(0, 7, "<world description=\"another\" "));
  begun.experiment.worlds.insert(begun.experiment.worlds.begin(),
                                 {"other", world, "other.xml", {}, {}});
  begun.experiment.repeats = 2;
  {
    auto database = ResultsDatabase::extend(begun.file, plan_of(begun.experiment));
    CHECK(database.added_runs() == 36 - 9);
    do_all(database);
  }
  CHECK(test::rows(begun.file, "SELECT id, label FROM cells ORDER BY place") ==
        "3|other, slow\n4|other, middling\n5|other, fast\n"
        "0|small, slow\n2|small, middling\n1|small, fast\n");
  CHECK(test::rows(begun.file,
                   "SELECT count(*), count(DISTINCT cell_id || ' ' || seed || ' ' || repetition) "
                   "FROM runs") == "36|36\n");
  CHECK(test::rows(begun.file,
                   "SELECT label, state_hash FROM runs JOIN cells ON cells.id = cell_id WHERE "
                   "runs.id = 4") == "small, fast|0000000000000004\n");
  CHECK(test::rows(begun.file, "PRAGMA foreign_key_check").empty());
  CHECK(ResultsDatabase::resume(begun.file, plan_of(begun.experiment)).pending().empty());
}

TEST_CASE("What exists may not go, and may not change") {
  Begun begun;
  const std::string before = test::all_tables(begun.file);
  const auto refusal = [&](const auto& change) -> std::string {
    Experiment changed = test::small_experiment(begun.folder);
    change(changed);
    try {
      ResultsDatabase::extend(begun.file, plan_of(changed));
    } catch (const batch::DatabaseRefused& error) {
      CHECK(test::all_tables(begun.file) == before);
      return error.what();
    }
    return "";
  };
  CHECK_THAT(refusal([](Experiment& e) {
               e.seeds = {1, 7, 9};
             }),
             Contains("cannot be extended to") &&
                 Contains("the seeds 2,18446744073709551615 (removed)") &&
                 Contains("levels, worlds and seeds may be added"));
  CHECK_THAT(refusal([](Experiment& e) {
               e.factors[0].levels.pop_back();
               e.seeds.push_back(3);
             }),
             Contains("the cell 'fast' (removed)"));
  CHECK_THAT(refusal([](Experiment& e) { e.factors[0].name = "tempo"; }),
             Contains("its factors are world and speed, and now world and tempo"));
  CHECK_THAT(refusal([](Experiment& e) {
               e.settings = {test::setting("arena/@length", "12")};
               e.seeds.push_back(3);
             }),
             Contains("the world '" + begun.folder.file("small.xml") + "' or what the experiment"));
  CHECK_THAT(refusal([](Experiment& e) { e.trajectory_period = 0.2; }),
             Contains("the period of the trajectories (0.1 s, now 0.2 s)"));
  begun.experiment.repeats = 3;
  ResultsDatabase::extend(begun.file, plan_of(begun.experiment));
  begun.experiment.repeats = 2;
  CHECK_THROWS_WITH(ResultsDatabase::extend(begun.file, plan_of(begun.experiment)),
                    Contains("the repetitions of each run (fewer)"));
}

TEST_CASE("A database is extended as a whole, or not at all") {
  Begun begun;
  const std::string before = test::all_tables(begun.file);
  add_level(begun.experiment, "middling", "0.2", 1);
  begun.experiment.seeds.push_back(9);
  // It fails after almost everything is written.
  test::rows(begun.file,
             "CREATE TRIGGER full BEFORE INSERT ON runs WHEN new.seed = 9 AND new.cell_id = 2 "
             "BEGIN SELECT raise(ABORT, 'no more room'); END");
  CHECK_THROWS_WITH(ResultsDatabase::extend(begun.file, plan_of(begun.experiment)),
                    Contains("no more room"));
  test::rows(begun.file, "DROP TRIGGER full");
  CHECK(test::all_tables(begun.file) == before);
  CHECK(ResultsDatabase::resume(begun.file, plan_of(test::small_experiment(begun.folder)))
            .pending()
            .empty());
  CHECK(ResultsDatabase::extend(begun.file, plan_of(begun.experiment)).added_runs() == 6);
}

TEST_CASE("Shards are extended each by itself, and merged to the whole that was extended") {
  Begun begun;
  Experiment larger = begun.experiment;
  add_level(larger, "middling", "0.2", 1);
  larger.seeds.push_back(9);
  std::vector<fs::path> parts;
  for (std::size_t index = 1; index <= 2; ++index) {
    parts.emplace_back(begun.folder.file("part" + std::to_string(index) + ".sqlite"));
    auto begins = ResultsDatabase::create(parts.back(), plan_of(begun.experiment, {index, 2}));
    do_all(begins);
  }
  const auto merged = [&](const std::string& name) {
    const std::string file = begun.folder.file(name);
    batch::merge(file, {parts[1], parts[0]});
    return file;
  };
  for (std::size_t index = 1; index <= 2; ++index) {
    {
      auto part = ResultsDatabase::extend(parts[index - 1], plan_of(larger, {index, 2}));
      CHECK(part.added_runs() == 6);
      CHECK(part.pending().size() == 3);
      do_all(part);
    }
    if (index == 1) {
      // One of them is still the smaller experiment.
      const std::string file = begun.folder.file("half.sqlite");
      CHECK(batch::merge(file, {parts[1], parts[0]}).missing == 3);
      auto half = ResultsDatabase::resume(file, plan_of(larger));
      CHECK(half.pending().size() == 3);
    }
  }
  {
    auto whole = ResultsDatabase::extend(begun.file, plan_of(larger));
    do_all(whole);
  }
  CHECK(test::all_tables(merged("all.sqlite")) == test::all_tables(begun.file));
}

TEST_CASE("A database that was begun with all is another than one that was extended to it") {
  Begun begun;
  begun.experiment.seeds.push_back(9);
  ResultsDatabase::extend(begun.file, plan_of(begun.experiment));
  const std::string fresh = begun.folder.file("fresh.sqlite");
  ResultsDatabase::create(fresh, plan_of(begun.experiment));
  CHECK_THROWS_WITH(batch::merge(begun.folder.file("m.sqlite"), {fresh, begun.file}),
                    Contains("belongs to another experiment"));
}

TEST_CASE("A database without its stages is damaged") {
  Begun begun;
  for (const char* change : {"UPDATE stages SET cells = 3", "DELETE FROM stages"}) {
    test::rows(begun.file, change);
    CHECK_THROWS_WITH(ResultsDatabase::resume(begun.file, plan_of(begun.experiment)),
                      Contains("is damaged (`stages`"));
  }
}

TEST_CASE("New cells bring their plugins and files, and share those that are there") {
  Begun begun;
  const std::string libraries = test::rows(begun.file, "SELECT count(*) FROM plugins");
  begun.experiment.factors[0].levels.push_back(
      {"measured",
       {test::setting("measures", "<measures><coverage cell=\"0.25\"/></measures>")},
       {}});
  ResultsDatabase::extend(begun.file, plan_of(begun.experiment));
  CHECK(test::rows(begun.file, "SELECT count(*) FROM plugins") ==
        std::to_string(std::stoi(libraries) + 1) + "\n");
  auto database = ResultsDatabase::open(begun.file);
  const auto run = database.run(7);
  REQUIRE(run);
  CHECK(run->libraries.size() == 6);
  CHECK(run->data.size() == 2);
  CHECK(database.run(1)->libraries.size() == 5);
  CHECK(run->program.size() == 5);
}

TEST_CASE("New cells may need libraries of the program that the old ones do not") {
  Begun begun;
  begun.experiment.factors[0].levels.push_back(
      {"flat", {test::setting("physics/@engine", "planar")}, {}});
  ResultsDatabase::extend(begun.file, plan_of(begun.experiment));
  const auto program = ResultsDatabase::open(begun.file).run(1)->program;
  REQUIRE(program.size() == 6);
  CHECK_THAT(program.back().path, Catch::EndsWith("planar.so"));
}

TEST_CASE("Stages that no experiment can have are damage, and are found before they are used") {
  Begun begun;
  const auto whole = begun.folder.read("r.sqlite");
  for (const char* damage :
       {"seeds = '-9223372036854775808'", "seeds = ''", "seeds = '1-20,x'", "seeds = '5-2'",
        "seeds = '0-18446744073709551615'", "repeats = 0", "repeats = 2000000000",
        "repeats = 4294967297", "cells = -1", "cells = 1000000"}) {
    CAPTURE(damage);
    begun.folder.write("r.sqlite", whole);
    test::rows(begun.file, "UPDATE stages SET " + std::string(damage));
    CHECK_THROWS_WITH(ResultsDatabase::resume(begun.file, plan_of(begun.experiment)),
                      Contains("' is damaged (") && Contains("`stages`"));
  }
}

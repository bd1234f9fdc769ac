#include <filesystem>

#include <catch2/catch.hpp>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include "elsie/batch/merge.h"
#include "elsie/batch/results_database.h"
#include "elsie/results/hash.h"

#include "../support/full_disk.h"
#include "support.h"
#include "tables.h"

using namespace elsie;
using batch::DatabaseRefused;
using batch::ResultsDatabase;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// Does something in a process of its own; returns how that ended, as waitpid() says it.
template <class Action>
int ending_of(const Action& action) {
  const pid_t child = fork();
  if (child == 0) _exit(action());
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

}  // namespace

TEST_CASE_METHOD(test::SmallBatch,
                 "A new database has all pending runs, and everything that they need") {
  {
    auto database = ResultsDatabase::create(file, plan);
    CHECK(database.pending() == std::vector<std::int64_t>{1, 2, 3, 4, 5, 6});
    CHECK(test::rows(file, "PRAGMA journal_mode") == "wal\n");  // while it is being written
  }
  CHECK(test::rows(file, "PRAGMA integrity_check; ") == "ok\n");
  CHECK(test::rows(file, "PRAGMA foreign_key_check").empty());
  CHECK(test::rows(file, "PRAGMA journal_mode") == "delete\n");
  CHECK(
      test::rows(file, "SELECT experiment, elsie_version, shard, runs, wall_limit_s FROM about") ==
      "small|1.2.3|1/1|6|60.0\n");
  CHECK(test::rows(file, "SELECT id, name FROM factors ORDER BY id") == "0|world\n1|speed\n");
  CHECK(
      test::rows(file, "SELECT cell_id, factor_id, label, place FROM cell_levels ORDER BY 1, 2") ==
      "0|0|small|0\n0|1|slow|0\n1|0|small|0\n1|1|fast|1\n");
  CHECK(test::rows(file, "SELECT seed FROM runs WHERE id = 3") == "-1\n");
  CHECK(test::rows(file,
                   "SELECT count(*) FROM cell_files JOIN files ON files.id = file_id WHERE kind = "
                   "'data' AND length(content) > 100") == "4\n");
  CHECK(test::rows(file,
                   "SELECT count(*) FROM plugins JOIN files ON files.id = file_id WHERE files.kind "
                   "= 'library' AND length(sha256) = 64") == "5\n");
  CHECK_FALSE(fs::exists(file + "-wal"));
  CHECK_FALSE(fs::exists(file + "-lock"));
}

TEST_CASE_METHOD(test::SmallBatch, "A run is written once, whole") {
  auto database = ResultsDatabase::create(file, plan);
  database.write(4, test::some_record());
  CHECK(database.pending() == std::vector<std::int64_t>{1, 2, 3, 5, 6});
  CHECK_THROWS_WITH(database.write(4, test::some_record()),
                    Contains("run 4 is not pending in the database"));
  CHECK_THROWS_WITH(database.write(7, test::some_record()), Contains("run 7 is not pending"));
  CHECK(test::rows(file,
                   "SELECT state, outcome, steps, simulated_s, solver_gave_up, solver_unsolved, "
                   "state_hash, exit_code FROM runs WHERE id = 4") ==
        "done|success|200|2.0|12|3|0123456789abcdef|0\n");
  CHECK(test::rows(file,
                   "SELECT measure, unit, value FROM run_measures JOIN measures ON measure = "
                   "name WHERE run_id = 4") == "success||1.0\ntime_s|s|2.0\n");
  CHECK(test::rows(file, "SELECT * FROM run_robots") == "4|r1|red|0.3|1|4998.0|3|1.0|-2.0|0.5\n");
  CHECK(test::rows(file, "SELECT place, name FROM run_events") == "0|collected\n1|hello\n");
  CHECK(test::rows(file, "SELECT poses FROM trajectories") == "[[0,0,0]]\n");
  CHECK(test::rows(file, "SELECT points FROM curves") == "[[1,0.5]]\n");
  CHECK(test::rows(file, "SELECT count(*) FROM timelines") == "1\n");
  CHECK(test::rows(file, "SELECT text FROM notes") == "It has learned.\n");
  CHECK(test::rows(file, "PRAGMA foreign_key_check").empty());
}

TEST_CASE_METHOD(test::SmallBatch,
                 "A run of which a part cannot be written is not written at all") {
  auto database = ResultsDatabase::create(file, plan);
  batch::RunRecord record = test::some_record();
  record.robots.push_back(record.robots[0]);  // twice
  CHECK_THROWS_AS(database.write(1, record), batch::DatabaseError);
  CHECK(database.pending().size() == 6);
  CHECK(test::rows(file, "SELECT count(*) FROM run_robots").substr(0, 1) == "0");
  CHECK(test::rows(file, "SELECT count(*) FROM measures").substr(0, 1) == "0");
  database.write(1, test::some_record());
  CHECK(database.pending().size() == 5);
}

TEST_CASE("Cells, failures and seeds that disagree are counted") {
  const test::Folder folder;
  auto experiment = test::small_experiment(folder);
  experiment.repeats = 2;
  const auto plan = test::plan_of(experiment);
  auto database = ResultsDatabase::create(folder.file("r.sqlite"), plan);
  database.write(1, test::some_record());
  database.write(2, test::some_record());
  database.write(3, test::some_record());
  database.write(4, test::some_record("fedcba9876543210"));
  batch::RunRecord fault;
  fault.state = batch::RunState::fault;
  fault.message = "plugin 'x' failed";
  database.write(7, fault);
  batch::RunRecord limit = test::some_record();
  limit.outcome = simulation::Outcome::time_limit;
  database.write(8, limit);
  const auto cells = database.cells();
  REQUIRE(cells.size() == 2);
  CHECK(cells[0].label == "slow");
  CHECK(cells[0].done == 4);
  CHECK(cells[0].successes == 4);
  CHECK(cells[0].pending == 2);
  CHECK(cells[1].failed == 1);
  CHECK(cells[1].done == 1);
  CHECK(cells[1].successes == 0);
  const auto failed = database.failed(10);
  REQUIRE(failed.size() == 1);
  CHECK(failed[0].id == 7);
  CHECK(failed[0].message == "plugin 'x' failed");
  const auto found = database.disagreements();
  REQUIRE(found.size() == 1);
  CHECK(found[0].cell == "slow");
  CHECK(found[0].seed == 2);
  CHECK(found[0].runs == std::vector<std::int64_t>{3, 4});

  CHECK(database.redo_failed() == 1);
  CHECK(database.failed(10).empty());
  const auto pending = database.pending();
  CHECK(std::find(pending.begin(), pending.end(), 7) != pending.end());
  database.write(7, test::some_record());
}

TEST_CASE_METHOD(test::SmallBatch, "A stored run has everything that is needed to repeat it") {
  auto database = ResultsDatabase::create(file, plan);
  database.write(6, test::some_record());
  const auto run = database.run(6);
  REQUIRE(run);
  CHECK(run->job.seed == 18446744073709551615U);
  CHECK(run->cell == "fast");
  CHECK_THAT(run->job.world_text, Contains("max_speed=\"0.4\""));
  CHECK(run->job.world_file == folder.file("small.xml"));
  REQUIRE(run->data.size() == 2);
  CHECK(run->data[0].name == "fuzzy_models/avoid_obstacle_left.fcl");
  CHECK(run->data[0].content.size() > 100);
  CHECK(run->libraries.size() == 5);
  REQUIRE(run->program.size() == 5);
  CHECK_THAT(run->program[0].path, Contains("libelsie.so"));
  CHECK_THAT(run->program[4].path, Contains("libode"));
  CHECK(run->record.state == batch::RunState::done);
  CHECK(run->record.state_hash == "0123456789abcdef");
  CHECK(run->record.solver_gave_up == 12U);
  CHECK(run->record.solver_unsolved == 3U);
  const batch::RunRecord written = test::some_record();
  REQUIRE(run->record.measures.size() == written.measures.size());
  for (const simulation::MeasuredValue& measure : written.measures) {
    CAPTURE(measure.name);
    const auto read = std::find_if(
        run->record.measures.begin(), run->record.measures.end(),
        [&](const simulation::MeasuredValue& other) { return other.name == measure.name; });
    REQUIRE(read != run->record.measures.end());
    CHECK(read->unit == measure.unit);
    CHECK(read->value == measure.value);
  }
  CHECK_FALSE(database.run(7));
}

TEST_CASE_METHOD(test::SmallBatch, "A batch continues only with its own database") {
  {
    auto database = ResultsDatabase::create(file, plan);
    database.write(1, test::some_record());
  }
  CHECK_THROWS_WITH(
      ResultsDatabase::create(file, plan),
      Contains("there is a database '" + file + "' already; continue it with --resume"));
  CHECK(ResultsDatabase::resume(file, plan).pending().size() == 5);

  auto other = test::small_experiment(folder);
  other.seeds.push_back(77);
  CHECK_THROWS_WITH(
      ResultsDatabase::resume(file, test::plan_of(other)),
      Contains("has 1 seed more than the database '" + file + "'; add them with --extend"));
  auto newer = test::plan_options();
  newer.elsie_version = "9.9.9";
  CHECK_THROWS_WITH(ResultsDatabase::resume(file, batch::make_plan(test::small_experiment(folder),
                                                                   test::shipped(), newer)),
                    Contains("begun with Elsie 1.2.3, and this is 9.9.9"));
  CHECK_THROWS_WITH(ResultsDatabase::resume(file, test::small_plan(folder, {1, 2})),
                    Contains("has the shard 1/1 of the experiment, not 1/2"));
}

TEST_CASE_METHOD(test::SmallBatch, "A model that has changed is named when a batch is resumed") {
  const auto options = test::with_models_in(folder);
  const auto experiment = test::small_experiment(folder);
  ResultsDatabase::create(file, batch::make_plan(experiment, test::shipped(), options));
  const std::string model = "fuzzy_models/avoid_obstacle_left.fcl";
  folder.write(model, folder.read(model) + "\n");
  CHECK_THROWS_WITH(
      ResultsDatabase::resume(file, batch::make_plan(experiment, test::shipped(), options)),
      Contains("changed since it was begun: the data file '" + folder.file(model) +
               "' (SHA-256 ") &&
          Contains(", now " + results::sha256(folder.read(model)).substr(0, 8) + ")"));
}

TEST_CASE_METHOD(test::SmallBatch,
                 "Of two files of one name that were moved, only the changed one is named") {
  REQUIRE(plan.cells[0].data.size() == 2);
  const auto moved = [&](const std::string& folder_of_all) {
    batch::Plan changed = plan;
    for (std::size_t i = 0; i < 2; ++i) {
      changed.files[plan.cells[0].data[i].file].path =
          folder_of_all + (i == 0 ? "/a/net.fcl" : "/b/net.fcl");
    }
    return changed;
  };
  ResultsDatabase::create(file, moved("/before"));
  batch::Plan now = moved("/now");
  now.cells[0].identity = "other";
  const auto difference = [&] {
    try {
      ResultsDatabase::resume(file, now);
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK_THAT(difference(), !Contains("net.fcl"));
  now.files[now.cells[0].data[1].file].sha256 = std::string(64, 'd');
  CHECK_THAT(difference(),
             Contains("the data file '/now/b/net.fcl' (SHA-256 ") && !Contains("/a/net.fcl"));
}

TEST_CASE_METHOD(test::SmallBatch,
                 "What else has changed is named, too: worlds, settings, libraries, cells") {
  ResultsDatabase::create(file, plan);
  const auto difference = [&](const batch::Plan& changed) -> std::string {
    try {
      ResultsDatabase::resume(file, changed);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  };
  const std::string before = plan.cells[0].sha256.substr(0, 8);
  batch::Plan world = plan;
  world.cells[0].identity = "other";
  world.cells[0].sha256 = std::string(64, 'b');
  CHECK_THAT(difference(world), Contains("the world '" + plan.cells[0].world_file +
                                         "' or what the experiment sets in it (SHA-256 " + before +
                                         ", now bbbbbbbb)"));
  batch::Plan program = plan;
  program.cells[0].identity = "other";
  program.files[0].sha256 = std::string(64, 'c');
  CHECK_THAT(difference(program),
             Contains("the program's library '" + plan.files[0].path + "' (SHA-256 " +
                      plan.files[0].sha256.substr(0, 8) + ", now cccccccc)"));
  batch::Plan plugin = plan;
  plugin.cells[0].identity = "other";
  REQUIRE(plugin.plugins[0].file);
  batch::PlannedFile& library = plugin.files[*plugin.plugins[0].file];
  library.sha256 = std::string(64, 'd');
  CHECK_THAT(difference(plugin), Contains("the plugin library '" + library.path + "' (SHA-256 ") &&
                                     Contains(", now dddddddd)"));
  library.path = "/elsewhere/libmine.so";
  CHECK_THAT(difference(plugin), Contains("the plugin library '/elsewhere/libmine.so' (SHA-256 ") &&
                                     Contains(", now dddddddd)"));
  batch::Plan cells = plan;
  cells.cells[0].levels[1] = "another";
  CHECK_THAT(difference(cells), Contains("changed since it was begun: the cell 'slow' (removed)"));
  batch::Plan text = plan;
  text.cells[0].identity = "other";
  text.text += " ";
  CHECK_THAT(difference(text), Contains("the experiment file '" + plan.file + "' (SHA-256 "));
}

TEST_CASE_METHOD(
    test::SmallBatch,
    "Files that are no database of results are refused with a sentence, and left alone") {
  const auto refused = [&](const std::string& wrong, const std::string& why) {
    CAPTURE(wrong);
    CHECK_THROWS_WITH(ResultsDatabase::open(wrong), Contains(why));
    CHECK_THROWS_WITH(ResultsDatabase::resume(wrong, plan), Contains(why));
    CHECK_THROWS_AS(ResultsDatabase::create(wrong, plan), DatabaseRefused);
  };
  const std::string text = folder.write("text.sqlite", std::string(5000, 'x'));
  refused(text, "is not an SQLite database");
  CHECK(folder.read("text.sqlite") == std::string(5000, 'x'));
  const std::string other = folder.file("other.sqlite");
  test::rows(other, "CREATE TABLE t (x)");
  refused(other, "is a database of another program");
  const std::string newer = folder.file("newer.sqlite");
  ResultsDatabase::create(newer, plan);
  test::rows(newer, "PRAGMA user_version = 7");
  refused(newer, "has version 7 of the schema, and this program reads version 6");
  CHECK_THROWS_WITH(ResultsDatabase::open(folder.file("none.sqlite")), Contains("there is no"));
  CHECK_THROWS_WITH(ResultsDatabase::create(folder.file("no/r.sqlite"), plan),
                    Contains("there is no folder"));
  CHECK_THROWS_WITH(ResultsDatabase::create("/proc/r.sqlite", plan),
                    Contains("no file can be created in the folder '/proc' (") &&
                        Contains("choose another folder"));
}

TEST_CASE_METHOD(test::SmallBatch,
                 "A number without a run is reported: it does not exist, or is in another shard") {
  ResultsDatabase::create(file, test::small_plan(folder, {2, 4}));
  auto shard = ResultsDatabase::open(file);
  CHECK(shard.run(6));
  CHECK_FALSE(shard.run(3));
  const std::string none = "the database '" + file + "' has no run ";
  CHECK(shard.why_no_run(3) ==
        none + "3: it has the shard 2/4 of the experiment, and this run is in shard 3/4");
  CHECK(shard.why_no_run(7) == none + "7: the runs of its experiment have numbers from 1 to 6");
  CHECK_THAT(shard.why_no_run(0), Contains("numbers from 1 to 6"));
  const std::string merged = folder.file("merged.sqlite");
  batch::merge(merged, {file});
  CHECK_THAT(ResultsDatabase::open(merged).why_no_run(3),
             Contains("it was merged from databases that do not have it; do it with `elsie"));
}

TEST_CASE_METHOD(
    test::SmallBatch,
    "A database that was moved is not written; the message says where its results are") {
  const std::string moved = folder.file("moved.sqlite");
  const std::string by = " while the batch wrote it; ";
  std::string why;
  {
    auto database = ResultsDatabase::create(file, plan);
    database.write(1, test::some_record());
    const auto refused = [&](const std::string& sentence) {
      CHECK_THROWS_WITH(database.write(3, test::some_record()), Contains(sentence));
      CHECK_THROWS_AS(database.require_in_place(), batch::DatabaseError);
    };
    SECTION("renamed") {
      fs::rename(file, moved);
      refused("the database '" + file + "' was renamed" + by + "the result of 1 run is in '" +
              fs::canonical(moved).string() + "': put it back");
    }
    SECTION("replaced") {
      database.write(2, test::some_record());
      fs::rename(file, moved);
      folder.write("r.sqlite", "mine");
      refused("another file has taken the place of the database '" + file + "'" + by +
              "the results of 2 runs are in '" + fs::canonical(moved).string() + "'");
      CHECK(folder.read("r.sqlite") == "mine");
    }
    SECTION("removed") {
      fs::remove(file);
      refused("the database '" + file + "' was removed" + by + "the result of 1 run is lost");
    }
  }
  CHECK_FALSE(fs::exists(file + "-lock"));
  CHECK_FALSE(fs::exists(file + "-wal"));
  if (fs::exists(moved)) {
    fs::rename(moved, file);
    const auto pending = ResultsDatabase::resume(file, plan).pending();
    CHECK(std::find(pending.begin(), pending.end(), 1) == pending.end());
    CHECK(pending.size() >= 4);
    CHECK(test::rows(file, "PRAGMA integrity_check") == "ok\n");
  }
}

TEST_CASE("An empty file is a database that was not begun") {
  const test::Folder folder;
  const std::string file = folder.write("r.sqlite", "");
  CHECK(results::is_vacant(file));
  CHECK(ResultsDatabase::create(file, test::small_plan(folder)).pending().size() == 6);
  CHECK_FALSE(results::is_vacant(file));
}

TEST_CASE_METHOD(test::SmallBatch,
                 "One batch at a time writes a database, while others may read it") {
  {
    auto first = ResultsDatabase::create(file, plan);
    CHECK_THROWS_WITH(
        ResultsDatabase::resume(file, plan),
        Contains("is being written by another batch (process " + std::to_string(getpid())));
    CHECK_THROWS_AS(ResultsDatabase::create(file, plan), DatabaseRefused);
    const std::string link = folder.file("link.sqlite");
    fs::create_symlink(file, link);
    CHECK_THROWS_WITH(ResultsDatabase::resume(link, plan), Contains("is being written by another"));
    first.write(1, test::some_record());
    CHECK(ResultsDatabase::open(file).pending().size() == 5);
    first.write(2, test::some_record());
  }
  CHECK(ResultsDatabase::resume(file, plan).pending().size() == 4);
}

TEST_CASE_METHOD(test::SmallBatch,
                 "The lock ends with the process, however that ends; written results stay") {
  const int status = ending_of([&] {
    auto database = ResultsDatabase::create(file, plan);
    database.write(1, test::some_record());
    return kill(getpid(), SIGKILL);
  });
  REQUIRE(WIFSIGNALED(status));
  CHECK(fs::exists(file + "-lock"));
  {
    auto database = ResultsDatabase::resume(file, plan);
    CHECK(database.pending() == std::vector<std::int64_t>{2, 3, 4, 5, 6});
  }
  CHECK_FALSE(fs::exists(file + "-lock"));
  CHECK(test::rows(file, "PRAGMA integrity_check") == "ok\n");
}

TEST_CASE_METHOD(test::SmallBatch,
                 "On a full disk the batch ends with a sentence, and what was written is valid") {
  const int status = ending_of([&] {
    const test::FullDisk disk(400'000);
    int code = 1;
    try {
      auto database = ResultsDatabase::create(file, plan);
      batch::RunRecord large = test::some_record();
      large.trajectories[0].poses = '[' + std::string(150'000, ' ') + ']';
      for (std::int64_t run = 1; run <= 6; ++run) {
        database.write(run, large);
      }
    } catch (const batch::DatabaseError& error) {
      const std::string what = error.what();
      code = what.find("could not be written: ") != std::string::npos ? 42 : 2;
    }
    return code;
  });
  CHECK(WEXITSTATUS(status) == 42);
  auto database = ResultsDatabase::resume(file, plan);
  const auto pending = database.pending();
  CHECK(pending.size() > 0);
  CHECK(pending.size() < 6);
  for (const std::int64_t run : pending) {
    database.write(run, test::some_record());
  }
  CHECK(test::rows(file, "PRAGMA integrity_check") == "ok\n");
}

TEST_CASE_METHOD(test::SmallBatch, "No database is left behind when it cannot be made") {
  const int status = ending_of([&] {
    const test::FullDisk disk(10'000);
    try {
      ResultsDatabase::create(file, plan);
    } catch (const batch::DatabaseError&) {
      return 42;
    }
    return 1;
  });
  CHECK(WEXITSTATUS(status) == 42);
  CHECK_FALSE(fs::exists(file));
  CHECK_FALSE(fs::exists(file + "-journal"));
  CHECK_FALSE(fs::exists(file + "-lock"));
}

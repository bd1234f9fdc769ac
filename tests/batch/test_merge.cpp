#include <filesystem>

#include <catch2/catch.hpp>

#include "elsie/batch/merge.h"
#include "elsie/batch/results_database.h"
#include "elsie/results/sqlite.h"

#include "support.h"
#include "tables.h"

using namespace elsie;
using batch::ResultsDatabase;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// A different record for each run.
batch::RunRecord merged_record(std::int64_t run) {
  batch::RunRecord record =
      test::some_record(simulation::hash_text(static_cast<std::uint64_t>(run)));
  record.robots[0].distance_m = static_cast<double>(run);
  if (run == 4) {
    record.measures.push_back({"extra", "m", "only this one has it", 4.0});
  }
  return record;
}

/// The record of a failed run, with its partial results.
batch::RunRecord failed(batch::RunState state, const std::string& message) {
  batch::RunRecord record = test::some_record();
  record.state = state;
  record.outcome.reset();
  record.state_hash.reset();
  record.measures.clear();
  record.message = message;
  return record;
}

std::string shard(const test::Folder& folder, std::size_t index, std::size_t of,
                  const std::string& name, bool complete = true) {
  const std::string file = folder.file(name);
  const batch::Plan plan = test::small_plan(folder, {index, of});
  auto database = ResultsDatabase::create(file, plan);
  for (const std::int64_t run : database.pending()) {
    if (complete || run != 6) {
      database.write(run, merged_record(run));
    }
  }
  return file;
}

}  // namespace

TEST_CASE_METHOD(test::SmallBatch, "Devices are written to by nobody, and stay") {
  const std::string part = shard(folder, 1, 1, "part.sqlite");
  const std::string device = folder.file("device.sqlite");
  fs::create_symlink("/dev/null", device);
  CHECK_THROWS_WITH(batch::merge(device, {part}), Contains("device.sqlite' is no file; choose"));
  CHECK_THROWS_WITH(ResultsDatabase::create(device, plan),
                    Contains("device.sqlite' is a device, not a file; expected a database"));
  CHECK(fs::is_symlink(device));
}

TEST_CASE("Shards that are merged are the whole, whatever their order") {
  const test::Folder folder;
  const std::string whole = shard(folder, 1, 1, "whole.sqlite");
  const std::string a = shard(folder, 1, 3, "a.sqlite");
  const std::string b = shard(folder, 2, 3, "b.sqlite");
  const std::string c = shard(folder, 3, 3, "c.sqlite");
  const std::string merged = folder.file("merged.sqlite");
  const auto count = batch::merge(merged, {c, a, b});
  CHECK(count.all_runs == 6);
  CHECK(count.pending == 0);
  CHECK(count.missing == 0);
  CHECK(count.duplicates == 0);
  CHECK(test::all_tables(merged) == test::all_tables(whole));
  CHECK(test::rows(merged, "PRAGMA integrity_check") == "ok\n");
  CHECK(test::rows(merged, "PRAGMA foreign_key_check").empty());
  CHECK(ResultsDatabase::open(merged).pending().empty());
}

TEST_CASE("Databases whose columns are in different orders can be merged") {
  const test::Folder folder;
  const std::string a = shard(folder, 1, 2, "a.sqlite");
  const std::string b = shard(folder, 2, 2, "b.sqlite");
  results::sqlite::Connection(b, results::sqlite::Connection::Mode::write)
      .run(
          "ALTER TABLE runs DROP COLUMN wall_s; ALTER TABLE runs ADD COLUMN wall_s REAL; "
          "UPDATE runs SET wall_s = 7.5");
  const std::string merged = folder.file("merged.sqlite");
  CHECK(batch::merge(merged, {a, b}).pending == 0);
  CHECK(test::rows(merged, "SELECT wall_s, state_hash FROM runs WHERE id IN (2, 4, 6)") ==
        test::rows(b, "SELECT 7.5, state_hash FROM runs"));
}

TEST_CASE_METHOD(test::SmallBatch,
                 "A run in two databases counts once; missing runs can be done later") {
  const std::string a = shard(folder, 1, 3, "a.sqlite");
  const std::string again = folder.file("again.sqlite");
  fs::copy(a, again);
  const std::string c = shard(folder, 3, 3, "c.sqlite", false);
  const std::string merged = folder.file("merged.sqlite");
  const auto count = batch::merge(merged, {a, again, c});
  CHECK(count.duplicates == 2);
  CHECK(count.pending == 1);
  CHECK(count.missing == 2);
  auto database = ResultsDatabase::resume(merged, plan);
  CHECK(database.pending() == std::vector<std::int64_t>{2, 5, 6});
}

TEST_CASE("A run that failed or is pending in one database and is done in another is done") {
  const test::Folder folder;
  const std::string good = shard(folder, 3, 3, "good.sqlite");
  for (const auto state : {batch::RunState::pending, batch::RunState::fault, batch::RunState::crash,
                           batch::RunState::hang, batch::RunState::error}) {
    const std::string bad = folder.file("bad.sqlite"), merged = folder.file("merged.sqlite");
    fs::remove(bad);
    const bool is_pending = state == batch::RunState::pending;
    {
      auto database = ResultsDatabase::create(bad, test::small_plan(folder, {3, 3}));
      if (!is_pending) database.write(6, failed(state, "no"));
    }
    for (const auto& order : {std::vector<fs::path>{bad, good}, std::vector<fs::path>{good, bad}}) {
      fs::remove(merged);
      const auto count = batch::merge(merged, order);
      CHECK(count.duplicates == (is_pending ? 0 : 1));  // run 3 is pending in one of them
      CHECK(count.pending == 0);
      CHECK(test::rows(merged, "SELECT state, message FROM runs WHERE id = 6") ==
            "done|all goals are reached\n");
      CHECK(test::rows(merged, "SELECT distance_m FROM run_robots WHERE run_id = 6") == "6.0\n");
      CHECK(test::rows(merged, "SELECT count(*) FROM trajectories WHERE run_id = 6") == "1\n");
      CHECK(test::rows(merged, "PRAGMA foreign_key_check").empty());
    }
  }
}

TEST_CASE("Of a run that failed in all databases the most telling end is kept, in any order") {
  const test::Folder folder;
  using batch::RunState;
  const std::vector<std::pair<RunState, std::string>> ends{{RunState::fault, "b"},
                                                           {RunState::fault, "a"},
                                                           {RunState::crash, "c"},
                                                           {RunState::hang, "d"},
                                                           {RunState::error, "e"}};
  std::vector<fs::path> files{folder.file("pending.sqlite")};
  ResultsDatabase::create(files[0].string(), test::small_plan(folder, {3, 3}));
  for (const auto& [state, message] : ends) {
    files.emplace_back(folder.file(message + ".sqlite"));
    ResultsDatabase::create(files.back().string(), test::small_plan(folder, {3, 3}))
        .write(6, failed(state, message));
  }
  const std::string merged = folder.file("merged.sqlite");
  const auto kept = [&](const std::vector<fs::path>& order) {
    fs::remove(merged);
    const auto count = batch::merge(merged, order);
    CHECK(count.duplicates == static_cast<std::int64_t>(order.size()) - 2);
    return test::rows(merged, "SELECT state, message FROM runs WHERE id = 6");
  };
  for (const char* end : {"fault|a\n", "crash|c\n", "hang|d\n", "error|e\n"}) {
    CHECK(kept(files) == end);
    CHECK(kept({files.rbegin(), files.rend()}) == end);
    files.erase(files.begin() + 1, files.begin() + (files.size() == 6 ? 3 : 2));
  }
}

TEST_CASE("Databases that do not fit together are refused, and nothing is left behind") {
  const test::Folder folder;
  const std::string a = shard(folder, 1, 3, "a.sqlite");
  const std::string merged = folder.file("merged.sqlite");
  const auto refused = [&](const std::vector<fs::path>& given, const std::string& why) {
    CHECK_THROWS_WITH(batch::merge(merged, given), Contains(why));
    CHECK_FALSE(fs::exists(merged));
    CHECK_FALSE(fs::exists(merged + "-journal"));
    CHECK_FALSE(fs::exists(merged + "-lock"));
  };
  auto other = test::small_experiment(folder);
  other.seeds = {5};
  const std::string b = folder.file("b.sqlite");
  ResultsDatabase::create(b, test::plan_of(other));
  refused({a, b}, "b.sqlite' belongs to another experiment than '" + a);
  refused({a, folder.write("c.sqlite", "text")}, "c.sqlite");
  refused({a, folder.file("none.sqlite")}, "there is no database");

  const std::string twin = folder.file("twin.sqlite");
  {
    auto database = ResultsDatabase::create(twin, test::small_plan(folder, {1, 3}));
    refused({a, twin}, "is being written by a batch (process ");
    database.write(1, test::some_record("ffffffffffffffff"));
  }
  refused({a, twin}, "run 1 has another result in '" + twin);

  fs::create_directory(folder.file("folder"));
  refused({a, folder.file("folder")}, "folder' is a directory; expected a database");
  refused({folder.file("folder"), a}, "folder' is a directory; expected a database");
  refused({a, a}, "the database '" + a + "' is named twice; name it once");
  fs::create_symlink(a, folder.file("link.sqlite"));
  refused({a, folder.file("link.sqlite")}, "'" + a + "' and '" + folder.file("link.sqlite") +
                                               "' are the same database; name it once");
  const std::string link = folder.file("link.sqlite");
  for (const auto& [name, is] :
       {std::pair(a, "'" + a + "' is read here"),
        std::pair(link, "'" + link + "' is the file '" + a + "', which is read here")}) {
    const std::string before = folder.read("a.sqlite");
    CHECK_THROWS_WITH(
        batch::merge(name, {a, twin}),
        Contains("OUT: " + is + ", and its content would be lost; choose another name"));
    CHECK(folder.read("a.sqlite") == before);
  }

  folder.write("merged.sqlite", "mine");
  CHECK_THROWS_WITH(batch::merge(merged, {a}), Contains("there is a file"));
  CHECK(folder.read("merged.sqlite") == "mine");
}

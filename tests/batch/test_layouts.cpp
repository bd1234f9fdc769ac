// The worlds of runs whose layouts follow the seeds: planned, stored, merged and run again.
#include <set>

#include <catch2/catch.hpp>

#include "elsie/batch/batch.h"
#include "elsie/batch/merge.h"
#include "elsie/batch/perform.h"
#include "elsie/results/hash.h"

#include "support.h"
#include "tables.h"

using namespace elsie;
using Catch::Contains;

namespace {

constexpr const char* kScattered = R"(<world format="1">
  <limits time="0.2"/>
  <layouts>
    <scatter id="c" count="4"><static_box/></scatter>
    <scatter id="start"><robot id="r1"/><heading/></scatter>
  </layouts>
</world>
)";

experiment::Experiment scattered(const test::Folder& folder,
                                 std::vector<experiment::Level> levels = {}) {
  experiment::Experiment experiment = test::small_experiment(folder);
  experiment.worlds[0].file = folder.write("small.xml", kScattered);
  experiment.factors = {{"boxes",
                         {{"few", {test::setting("scatter[c]/@count", "2")}, {}},
                          {"many", {test::setting("scatter[c]/@count", "5")}, {}}},
                         {}}};
  if (!levels.empty()) experiment.factors = {{"layout_seed", std::move(levels), {}}};
  return experiment;
}

}  // namespace

TEST_CASE("Each seed has a world of its own, and each run gets that of its seed") {
  const test::Folder folder;
  const batch::Plan plan = test::plan_of(scattered(folder));
  REQUIRE(plan.cells.size() == 2);
  for (const batch::PlannedCell& cell : plan.cells) {
    CHECK_FALSE(cell.layout_seed);
    REQUIRE(cell.layouts.size() == 3);
    CHECK(cell.world_text == cell.layouts.at(1).world_text);
    std::set<std::string> texts;
    for (const auto& [seed, layout] : cell.layouts) {
      texts.insert(layout.world_text);
      CHECK(layout.sha256 == results::sha256(layout.world_text));
      CHECK_THAT(layout.world_text, !Contains("layouts"));
    }
    CHECK(texts.size() == 3);
  }
  CHECK(batch::job_of(plan, plan.runs[1]).world_text == plan.cells[0].layouts.at(2).world_text);
  CHECK(batch::job_of(plan, plan.runs[5]).world_text ==
        plan.cells[1].layouts.at(18446744073709551615U).world_text);
}

TEST_CASE("A layout with a seed of its own is the same for all runs of a cell") {
  const test::Folder folder;
  const batch::Plan plan =
      test::plan_of(scattered(folder, {{"7", {test::setting("layouts/@seed", "7")}, {}},
                                       {"8", {test::setting("layouts/@seed", "8")}, {}}}));
  CHECK(plan.cells[0].layouts.empty());
  CHECK(plan.cells[0].layout_seed == 7U);
  CHECK(plan.cells[1].layout_seed == 8U);
  CHECK(plan.cells[0].world_text != plan.cells[1].world_text);
}

TEST_CASE("The fingerprint covers what every seed draws") {
  const test::Folder folder;
  const std::string before = test::plan_of(scattered(folder)).fingerprint;
  CHECK(test::plan_of(scattered(folder)).fingerprint == before);
  folder.write("small.xml", kScattered);
  experiment::Experiment other = scattered(folder);
  other.settings.push_back(test::setting("scatter[c]/@gap", "0.051"));
  CHECK(test::plan_of(other).fingerprint == before);  // it draws the same worlds
  other.settings.push_back(test::setting("scatter[c]/@gap", "1.5"));
  CHECK(test::plan_of(other).fingerprint != before);
}

TEST_CASE("A database that is extended by seeds gets their layouts, and keeps those it has") {
  const test::Folder folder;
  const std::string file = folder.file("runs.sqlite");
  experiment::Experiment experiment = scattered(folder);
  experiment.seeds = {1, 2};
  batch::ResultsDatabase::create(file, test::plan_of(experiment));
  const std::string query = "SELECT seed, sha256 FROM layouts WHERE seed < 3 ORDER BY cell_id, 1";
  const std::string before = test::rows(file, query);
  experiment.seeds = {0, 1, 2, 3};
  batch::ResultsDatabase::extend(file, test::plan_of(experiment));
  CHECK(test::rows(file, "SELECT count(*) FROM layouts") == "8\n");
  CHECK(test::rows(file,
                   "SELECT seed, sha256 FROM layouts WHERE seed IN (1, 2) "
                   "ORDER BY cell_id, 1") == before);
  CHECK(test::rows(file, "SELECT count(*) FROM run_worlds WHERE layout_seed IS NULL") == "0\n");
  experiment.settings.push_back(test::setting("scatter[c]/@gap", "1.5"));
  CHECK_THROWS_AS(batch::ResultsDatabase::resume(file, test::plan_of(experiment)),
                  results::DatabaseRefused);
}

TEST_CASE("The database has the layout of every run, also when it is merged from shards") {
  const test::Folder folder;
  const auto write = [&](const std::string& name, batch::Shard shard) {
    const std::string file = folder.file(name);
    const batch::Plan plan = test::plan_of(scattered(folder), shard);
    auto database = batch::ResultsDatabase::create(file, plan);
    for (const batch::PlannedRun& run : plan.runs) {
      database.write(run.id, batch::perform(batch::job_of(plan, run)));
    }
    return file;
  };
  const std::string all = write("all.sqlite", {});
  const std::string query = "SELECT run_id, layout_seed, world_text FROM run_worlds ORDER BY 1";
  CHECK(test::rows(all, "SELECT layout_seed FROM run_worlds ORDER BY run_id") ==
        "1\n2\n-1\n1\n2\n-1\n");
  CHECK(test::rows(all, "SELECT count(DISTINCT world_text) FROM run_worlds") == "6\n");
  batch::merge(folder.file("merged.sqlite"),
               {write("first.sqlite", {1, 2}), write("second.sqlite", {2, 2})});
  CHECK(test::rows(folder.file("merged.sqlite"), query) == test::rows(all, query));

  auto database = batch::ResultsDatabase::open(all);
  const auto run = database.run(2);
  REQUIRE(run);
  CHECK(batch::perform(run->job).state_hash == run->record.state_hash);
  CHECK(run->record.state_hash != database.run(1)->record.state_hash);
}

TEST_CASE("A layout that was changed in the database is noticed") {
  const test::Folder folder;
  const std::string file = folder.file("runs.sqlite");
  batch::ResultsDatabase::create(file, test::plan_of(scattered(folder)));
  test::rows(file, "UPDATE layouts SET world_text = world_text || ' ' WHERE seed = 2");
  CHECK_THROWS_WITH(batch::ResultsDatabase::open(file),
                    Contains("the world of cell 'few, seed 2' does not match its hash"));
}

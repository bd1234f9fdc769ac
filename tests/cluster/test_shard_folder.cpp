#include <filesystem>
#include <fstream>
#include <future>

#include <catch2/catch.hpp>

#include "elsie/batch/results_database.h"
#include "elsie/cluster/shard_folder.h"

#include "folder.h"

using Catch::Contains;
using elsie::batch::DatabaseRefused;
using elsie::batch::Plan;
using elsie::cluster::ShardFolder;

namespace {

Plan plan_of(std::int64_t runs, const std::string& fingerprint = "abc") {
  Plan plan;
  plan.all_runs = runs;
  plan.fingerprint = fingerprint;
  return plan;
}

/// The folder of a batch.
class ClusterFolder : public elsie::test::Folder {
 public:
  std::string database() const { return file("results.sqlite"); }
};

}  // namespace

TEST_CASE("The shards have all runs, divided as evenly as possible") {
  const ClusterFolder here;
  const ShardFolder folder = ShardFolder::create(here.database(), plan_of(10), 4, {"elsie"});
  CHECK(folder.runs(1) == 3);
  CHECK(folder.runs(2) == 3);
  CHECK(folder.runs(3) == 2);
  CHECK(folder.runs(4) == 2);
  CHECK(folder.unfinished() == std::vector<std::size_t>{1, 2, 3, 4});
  CHECK(folder.unfinished({2, 4}) == std::vector<std::size_t>{1, 3});
  CHECK(folder.pending(3) == 2);
}

TEST_CASE("The progress of a batch is the sum of its shards'") {
  const ClusterFolder here;
  const ShardFolder folder = ShardFolder::create(here.database(), plan_of(10), 2, {"elsie"});
  CHECK(folder.count().runs == 10);
  CHECK(folder.count().ended == 0);
  elsie::cluster::write_count(folder.path() / "shard-1.json", {.runs = 5, .ended = 3, .failed = 1});
  elsie::cluster::write_count(folder.path() / "shard-2.json", {.runs = 5, .ended = 4});
  CHECK(folder.count().ended == 7);
  CHECK(folder.count().failed == 1);
  std::ofstream(folder.path() / "shard-2.json") << "{\"ended\": ";
  CHECK(folder.count().ended == 3);  // a damaged file counts nothing
  std::ofstream(folder.path() / "shard-2.json") << "{\"ended\": \"all\"}";
  CHECK(folder.count().ended == 3);
}

TEST_CASE("A folder is resumed for the same experiment only") {
  const ClusterFolder here;
  CHECK_FALSE(ShardFolder::find(here.database(), plan_of(10)).has_value());
  {
    ShardFolder folder = ShardFolder::create(here.database(), plan_of(10), 2, {"elsie"});
    folder.set_job("17");
  }
  const ShardFolder again = ShardFolder::find(here.database(), plan_of(10)).value();
  CHECK(again.shards() == 2);
  CHECK(again.job() == "17");
  CHECK_THROWS_AS(ShardFolder::find(here.database(), plan_of(10, "other")), DatabaseRefused);
  CHECK_THROWS_AS(ShardFolder::create(here.database(), plan_of(10), 2, {"elsie"}), DatabaseRefused);
  for (const char* wrong :
       {"", "{", "[]", "{\"shards\": 0, \"fingerprint\": \"abc\"}",
        "{\"shards\": \"2\", \"fingerprint\": \"abc\"}", "{\"shards\": 2, \"fingerprint\": 3}",
        "{\"shards\": 2}", "{\"shards\": 2, \"fingerprint\": \"abc\", \"job\": 17}"}) {
    CAPTURE(wrong);
    std::ofstream(again.path() / "cluster.json") << wrong;
    CHECK_THROWS_AS(ShardFolder::find(here.database(), plan_of(10)), DatabaseRefused);
  }
  again.remove();
  CHECK_FALSE(again.exists());
  CHECK_FALSE(std::filesystem::exists(again.path()));
}

TEST_CASE("A folder is there as a whole or not at all while it is made and removed") {
  const ClusterFolder here;
  const auto found = [&] { return ShardFolder::find(here.database(), plan_of(10)); };
  for (int round = 0; round < 100; ++round) {
    auto maker = std::async(std::launch::async, [&] {
      return ShardFolder::create(here.database(), plan_of(10), 2, {"elsie"});
    });
    while (!found()) {
    }
    auto remover = std::async(std::launch::async, [&] { maker.get().remove(); });
    while (found()) {
    }
  }
  CHECK_FALSE(std::filesystem::exists(here.database() + "-shards"));
}

TEST_CASE("Arrays of other folders and other experiments have other names") {
  const ClusterFolder here;
  const auto name = [&](const char* file, const char* fingerprint) {
    const auto folder =
        ShardFolder::create(here.file(file), plan_of(10, fingerprint), 2, {"elsie", "batch"});
    const std::string found = folder.name();
    folder.remove();
    return found;
  };
  CHECK(name("a.sqlite", "x") == name("a.sqlite", "x"));
  CHECK(name("a.sqlite", "x") != name("b.sqlite", "x"));
  CHECK(name("a.sqlite", "x") != name("a.sqlite", "y"));
}

TEST_CASE("A task's script quotes what a shell would take apart") {
  const ClusterFolder here;
  const auto folder = ShardFolder::create(here.file("it's here.sqlite"), plan_of(10), 2,
                                          {"/opt/elsie", "batch", "my study.xml", "$HOME"});
  std::ifstream file(folder.script());
  const std::string script{std::istreambuf_iterator<char>(file), {}};
  CHECK_THAT(script, Contains("exec /opt/elsie batch 'my study.xml' '$HOME' --shard "
                              "\"$SLURM_ARRAY_TASK_ID\"/2"));
  CHECK_THAT(script,
             Contains("it'\\''s here.sqlite-shards/shard-'\"$SLURM_ARRAY_TASK_ID\".sqlite"));
}

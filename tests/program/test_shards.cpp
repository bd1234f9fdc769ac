// Shards of an experiment, and elsie merge.
#include <string>

#include <catch2/catch.hpp>

#include "laboratory.h"

using Catch::Contains;
using elsie::test::Laboratory;

TEST_CASE("Shards that are merged are the whole experiment") {
  const Laboratory here;
  REQUIRE(here.batch("small_experiment.xml --quiet --database whole.sqlite").exit_code == 0);
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    CHECK(here.batch("small_experiment.xml --quiet --shard " + std::string(shard)).exit_code == 0);
  }
  CHECK(here.query("small_experiment-2of3.sqlite", "SELECT count(*) FROM runs") == "8\n");
  const auto merged = here.elsie(
      "merge merged.sqlite small_experiment-3of3.sqlite small_experiment-1of3.sqlite "
      "small_experiment-2of3.sqlite");
  CHECK(merged.exit_code == 0);
  CHECK(merged.out == "merged.sqlite: 24 of 24 runs are done\n");
  CHECK(here.table("merged.sqlite") == here.table("whole.sqlite"));
  here.check_sound("merged.sqlite");

  const auto part = here.elsie("merge part.sqlite small_experiment-1of3.sqlite");
  CHECK_THAT(part.out,
             Contains("part.sqlite: 8 of 24 runs are done") && Contains("16 are still to be done"));
  CHECK(here.batch("small_experiment.xml --quiet --database part.sqlite --resume").exit_code == 0);
  CHECK(here.table("part.sqlite") == here.table("whole.sqlite"));

  const auto wrong = here.batch("small_experiment.xml --shard 4/3");
  CHECK(wrong.exit_code == 2);
  CHECK_THAT(wrong.err, Contains("--shard: '4/3' is no part of an experiment"));
}

// Shards of an experiment, and elsie merge.
#include <filesystem>
#include <string>

#include <catch2/catch.hpp>
#include <sys/stat.h>

#include "laboratory.h"

using Catch::Contains;
using elsie::test::Laboratory;
namespace fs = std::filesystem;

TEST_CASE("What cannot be merged is refused in a sentence, and nothing is made") {
  const Laboratory here;
  REQUIRE(here.batch("small_experiment.xml --quiet --shard 1/3 --database a.sqlite").exit_code ==
          0);
  fs::create_symlink("a.sqlite", here.file("link.sqlite"));
  fs::create_directory(here.file("folder"));
  const auto refused = [&](const std::string& arguments, const std::string& sentence) {
    CAPTURE(arguments);
    const auto run = here.elsie("merge " + arguments);
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.err, Contains(sentence));
    CHECK_FALSE(fs::exists(here.file("out.sqlite")));
  };
  refused("out.txt a.sqlite",
          "OUT: expected a name that ends in .sqlite, .sqlite3 or .db, but 'out.txt' does not");
  CHECK_FALSE(fs::exists(here.file("out.txt")));
  refused("out.sqlite folder", "'folder' is a directory; expected a database");
  refused("out.sqlite a.sqlite folder", "'folder' is a directory; expected a database");
  refused("out.sqlite a.sqlite ./a.sqlite", "'a.sqlite' and './a.sqlite' are the same database");
  refused("out.sqlite link.sqlite a.sqlite", "'link.sqlite' and 'a.sqlite' are the same database");
  refused("a.sqlite a.sqlite", "OUT: 'a.sqlite' is read here, and its content would be lost");
  refused("link.sqlite a.sqlite", "OUT: 'link.sqlite' is the file 'a.sqlite', which is read here");
  REQUIRE(mkfifo(here.file("pipe").c_str(), 0600) == 0);
  refused("out.sqlite pipe", "'pipe' is a pipe, not a file; expected a database");
  refused("out.sqlite a.sqlite pipe", "'pipe' is a pipe, not a file; expected a database");
  here.check_sound("a.sqlite");
}

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
  // A shell accepts the command that resumes the batch.
  fs::copy(here.file("small_experiment.xml"), here.file("my experiment.xml"));
  REQUIRE(here.batch("'my experiment.xml' --quiet --shard 1/3 --database a.sqlite").exit_code == 0);
  const std::string summary = here.elsie("merge 'my part.sqlite' a.sqlite").out;
  const std::string goes_on =
      "elsie batch 'my experiment.xml' --database 'my part.sqlite' --resume";
  CHECK_THAT(summary, Catch::EndsWith(": " + goes_on + "\n"));
  CHECK(here.sh(goes_on + " --quiet --plugin-path " + here.plugins()).exit_code == 0);
  CHECK(here.table("part.sqlite") == here.table("whole.sqlite"));

  const auto elsewhere = here.elsie("replay small_experiment-2of3.sqlite 6");
  CHECK(elsewhere.exit_code == 2);
  CHECK_THAT(elsewhere.err,
             Contains("'small_experiment-2of3.sqlite' has no run 6: it has the shard "
                      "2/3 of the experiment, and this run is in shard 3/3"));

  const auto wrong = here.batch("small_experiment.xml --shard 4/3");
  CHECK(wrong.exit_code == 2);
  CHECK_THAT(wrong.err, Contains("--shard: '4/3' is not a shard"));
}

// Databases of results that other programs change.
#include <filesystem>
#include <string>

#include <catch2/catch.hpp>

#include "laboratory.h"

using Catch::Contains;
using elsie::test::Laboratory;
namespace fs = std::filesystem;

TEST_CASE("A damaged database is refused by all commands that read it, with what to do") {
  const Laboratory here;
  REQUIRE(here.batch("small_experiment.xml --quiet --database whole.sqlite").exit_code == 0);
  const std::string whole = here.read("whole.sqlite");
  constexpr std::size_t kPage = 4096;
  const std::size_t middle = whole.size() / kPage / 2 * kPage;
  REQUIRE(middle > kPage);
  std::string damaged = whole;
  damaged.replace(middle, kPage, std::string(kPage, 'x'));
  here.write("r.sqlite", damaged);
  for (const std::string command :
       {"batch small_experiment.xml --database r.sqlite --resume", "report r.sqlite",
        "replay r.sqlite 1", "merge out.sqlite r.sqlite",
        "merge out.sqlite whole.sqlite r.sqlite"}) {
    CAPTURE(command);
    const auto run =
        here.elsie(command + (command[0] == 'b' ? " --plugin-path " + here.plugins() : ""));
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK_THAT(run.err, Contains("elsie: the database 'r.sqlite' is damaged (") &&
                            Contains("use a copy of it, or do its runs again with another "
                                     "--database"));
    CHECK(here.read("r.sqlite") == damaged);
    CHECK_FALSE(fs::exists(here.file("out.sqlite")));
  }
}

TEST_CASE("A batch whose database is taken away stops, and says where its results are") {
  const Laboratory here;
  here.write_faulty({"dawdling"}, Laboratory::kTwoDawdledSteps, 2);
  /// Changes the database between the first run and the second.
  const auto batch_during = [&](const std::string& action) {
    return here.sh(Laboratory::kDawdlesOnRequest +
                   "elsie batch faulty.xml --workers 1 --quiet --plugin-path " +
                   Laboratory::plugins() +
                   " & batch=$!\n"
                   "pass_one; pass_one\n"
                   "while ! sqlite3 faulty.sqlite 'SELECT count(*) FROM runs WHERE state = "
                   "\"done\"' 2>/dev/null | grep -q 1; do sleep 0.05; done\n" +
                   action +
                   "\n"
                   "pass_all; wait $batch && code=$? || code=$?\n"
                   "exit $code");
  };
  SECTION("renamed: it is put back, and the batch continues") {
    const auto run = batch_during("mv faulty.sqlite elsewhere.sqlite");
    CHECK(run.exit_code == 4);
    CHECK_THAT(run.err, Contains("the database 'faulty.sqlite' was renamed while the batch wrote "
                                 "it; the result of 1 run is in '") &&
                            Contains("elsewhere.sqlite': put it back"));
    here.check_sound("elsewhere.sqlite");
    fs::rename(here.file("elsewhere.sqlite"), here.file("faulty.sqlite"));
    CHECK(here.batch_at_once("faulty.xml --quiet --resume").exit_code == 0);
    CHECK(here.query("faulty.sqlite", "SELECT state FROM runs") == "done\ndone\n");
  }
  SECTION("replaced: the other file is left alone") {
    const auto run = batch_during("mv faulty.sqlite elsewhere.sqlite; echo mine > faulty.sqlite");
    CHECK(run.exit_code == 4);
    CHECK_THAT(run.err, Contains("another file has taken the place of the database "
                                 "'faulty.sqlite' while the batch wrote it; the result of 1 run"));
    CHECK(here.read("faulty.sqlite") == "mine\n");
    here.check_sound("elsewhere.sqlite");
  }
  SECTION("removed: the results are lost") {
    const auto run = batch_during("rm faulty.sqlite");
    CHECK(run.exit_code == 4);
    CHECK_THAT(run.err, Contains("the database 'faulty.sqlite' was removed while the batch wrote "
                                 "it; the result of 1 run is lost"));
    CHECK_FALSE(fs::exists(here.file("faulty.sqlite")));
  }
}

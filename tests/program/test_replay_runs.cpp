// `elsie replay DATABASE RUN`: what it compares, and its messages about runs that do not end.
#include <catch2/catch.hpp>

#include "laboratory.h"

using Catch::Contains;
using elsie::test::Laboratory;

namespace {

/// A replay of the plugin `dawdling` that may take this time on the clock ends in a dawdled step:
/// which, depends on the machine.
constexpr const char* kDawdledLimit = "--wall-limit 1.5 ";
auto ends_in_a_dawdled_step(const std::string& before, const std::string& after) {
  return Catch::Matches(
      "(.|\\n)*" + before +
      ": after 1[.]5 s on the clock it was in step 5[0-9] [(]at 0[.]5[0-9]* s[)] and went on" +
      after + "(.|\\n)*");
}

}  // namespace

TEST_CASE("A replay compares outcome, steps and every measure too") {
  const Laboratory here;
  here.write("small_experiment.xml", Laboratory::experiment("<world file=\"small.xml\"/>", "", 1));
  REQUIRE(here.batch("small_experiment.xml --quiet").exit_code == 0);
  const auto replay = [&](const std::string& change) {
    here.query("small_experiment.sqlite", change);
    const auto run = here.elsie("replay small_experiment.sqlite 1 --quiet");
    CHECK(run.exit_code == 1);
    CHECK(run.err.empty());
    return run.out;
  };
  CHECK(replay("UPDATE run_measures SET value = 2.5 WHERE measure = 'time_s'") ==
        "not the same: measure time_s 2 s, before 2.5 s\n");
  CHECK(replay("UPDATE run_measures SET value = NULL WHERE measure = 'time_s'") ==
        "not the same: measure time_s 2 s, before none\n");
  CHECK(replay("DELETE FROM run_measures WHERE measure = 'time_s'") ==
        "not the same: measure time_s 2 s, before not measured\n");
  CHECK(replay("INSERT INTO measures VALUES ('gap', 'm', 'a gap');"
               "INSERT INTO run_measures VALUES (1, 'gap', 0.1)") ==
        "not the same: measure time_s 2 s, before not measured\n"
        "              measure gap not measured, before 0.1 m\n");
  here.query("small_experiment.sqlite",
             "DELETE FROM run_measures WHERE measure = 'gap';"
             "INSERT INTO run_measures VALUES (1, 'time_s', 2)");
  CHECK(replay("UPDATE runs SET outcome = 'success', steps = 7") ==
        "not the same: outcome time_limit, before success\n"
        "              steps 200, before 7\n");
}

TEST_CASE("A run that hangs is ended at the batch's wall limit, and its plugin named") {
  const Laboratory here;
  here.write_faulty({"looping"}, "<limits time=\"2\" wall_time=\"5\"/>");
  REQUIRE(here.batch("faulty.xml --quiet").exit_code == 3);

  const auto run =
      here.elsie("replay faulty.sqlite 1 --record run.csv --record run.mcap --record-rate 100");
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.out, Contains("before: hang, the run did not end within 5 s"));
  CHECK_THAT(run.err,
             Contains("elsie: plugin 'looping' of robot 'r1' did not return before the wall limit "
                      "of the run in step 50 (at 0.5 s)\n") &&
                 Contains("what was recorded until then is kept\n") && Contains("the stack"));
  CHECK_THAT(here.read("run.csv"), Contains("\n0.5,") && Catch::EndsWith("\n"));
  const auto explained = here.elsie("explain run.mcap");
  CHECK(explained.exit_code == 0);
  CHECK_THAT(explained.out, Contains("0.5 s"));
}

TEST_CASE("A slow run is distinguished from one that hangs") {
  const Laboratory here;
  here.write_faulty({"dawdling"}, "<limits time=\"2\" wall_time=\"5\"/>");
  REQUIRE(here.batch("faulty.xml --quiet").exit_code == 3);
  const auto run = here.elsie(std::string("replay faulty.sqlite 1 --quiet ") + kDawdledLimit +
                              "--picture run.png --record run.mcap");
  CHECK(run.exit_code == 1);
  CHECK(run.err.empty());
  CHECK_THAT(run.out,
             ends_in_a_dawdled_step("not the same: the run is slow, and does not hang",
                                    ", before hang: .*\\n--wall-limit gives it more time\\n"));
  CHECK(here.read("run.png").starts_with("\x89PNG"));
  CHECK_THAT(here.elsie("replay run.mcap").out, Contains("complete"));
}

TEST_CASE("A replay can be limited whatever the result of the run was; most are not") {
  const Laboratory here;
  here.write_faulty({"dawdling"}, "<limits time=\"0.6\"/>");
  REQUIRE(here.batch_at_once("faulty.xml --quiet").exit_code == 0);
  here.query("faulty.sqlite", "UPDATE about SET wall_limit_s = 0.0001");
  CHECK_THAT(here.elsie_at_once("replay faulty.sqlite 1 --quiet").out,
             Catch::StartsWith("the same: "));
  const auto run = here.elsie(std::string("replay faulty.sqlite 1 --quiet ") + kDawdledLimit);
  CHECK(run.exit_code == 1);
  CHECK_THAT(run.out,
             ends_in_a_dawdled_step("not the same: the run has not ended", ", before done: "));
  here.query("faulty.sqlite",
             "UPDATE runs SET state = 'hang', plugin = 'dawdling', robot = 'r1', "
             "step = 51, outcome = NULL");
  const auto unlimited = here.elsie_at_once("replay faulty.sqlite 1 --quiet --wall-limit 0");
  CHECK(unlimited.exit_code == 1);
  CHECK_THAT(unlimited.out, Contains("not the same: it ended normally"));
}

// `elsie replay DATABASE RUN`: what it compares, and how it tells of what does not come to its end.
#include <catch2/catch.hpp>

#include "laboratory.h"

using Catch::Contains;
using elsie::test::Laboratory;

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
  here.query("small_experiment.sqlite", "DELETE FROM run_measures WHERE measure = 'gap';"
                                        "INSERT INTO run_measures VALUES (1, 'time_s', 2)");
  CHECK(replay("UPDATE runs SET outcome = 'success', steps = 7") ==
        "not the same: outcome time_limit, before success\n"
        "              steps 100, before 7\n");
}

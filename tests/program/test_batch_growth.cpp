// elsie batch --extend, formulas, excluded combinations, and recordings of chosen runs.
#include <filesystem>
#include <fstream>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "laboratory.h"

using Catch::Contains;
using elsie::test::Laboratory;
namespace fs = std::filesystem;

namespace {

std::string speeds(const std::string& values, const std::string& more = "") {
  return "<vary name=\"speed\" path=\"robot[r1]/@max_speed\" values=\"" + values + "\"/>" + more;
}

void write_grown(const Laboratory& here) {
  here.write("small_experiment.xml", Laboratory::experiment("<world file=\"small.xml\"/>",
                                                            speeds("0.05; 0.1; 0.2; 0.4"), 10));
}

}  // namespace

TEST_CASE("A batch goes on with another build of what draws charts, not of what decides its runs") {
  const Laboratory here;
  // Elsie in a folder of its own. A byte more makes a library another one, which works as before.
  fs::create_directory(here.file("bin"));
  fs::copy(elsie::test::build_path("bin/elsie"), here.file("bin/elsie"));
  fs::copy(elsie::test::build_path("lib"), here.file("lib"),
           fs::copy_options::recursive | fs::copy_options::copy_symlinks);
  fs::create_directory_symlink(elsie::test::build_path("share"), here.file("share"));
  const auto batch = [&](const std::string& option) {
    return here.sh("LD_LIBRARY_PATH=\"$PWD/lib\" bin/elsie batch small_experiment.xml --quiet " +
                   option);
  };
  const auto rebuild = [&](const std::string& library) {
    std::ofstream(here.file("lib/" + library), std::ios::app | std::ios::binary) << '\n';
  };
  REQUIRE(batch("").exit_code == 0);
  for (const char* const library : {"libelsie-views.so", "libelsie-render.so", "libelsie-vision.so",
                                    "elsie/layouts.so", "elsie/engines/planar.so"}) {
    CAPTURE(library);
    rebuild(library);
    const auto resumed = batch("--resume");
    CHECK(resumed.err.empty());
    CHECK(resumed.exit_code == 0);
  }
  for (const char* const library : {"elsie/engines/ode.so", "libelsie.so"}) {
    CAPTURE(library);
    const std::string before = here.read(std::string("lib/") + library);
    rebuild(library);
    const auto resumed = batch("--resume");
    CHECK(resumed.exit_code == 2);
    CHECK_THAT(resumed.err, Contains("the program's library '") && Contains(library));
    here.write(std::string("lib/") + library, before);
    CHECK(batch("--resume").exit_code == 0);
  }
}

TEST_CASE("An experiment grows in its database; old runs stay, new ones are what they would be") {
  const Laboratory here;
  REQUIRE(here.batch("small_experiment.xml --quiet").exit_code == 0);
  const std::string old_runs = "SELECT id, seed, state_hash FROM runs WHERE id <= 24";
  const std::string before = here.query("small_experiment.sqlite", old_runs);
  write_grown(here);
  const auto resumed = here.batch("small_experiment.xml --resume");
  CHECK(resumed.exit_code == 2);
  CHECK(resumed.err ==
        "elsie: the experiment 'small_experiment.xml' has 1 cell and 2 seeds more than the "
        "database 'small_experiment.sqlite'; add them with --extend, or choose another "
        "--database\n");
  const auto extended = here.batch("small_experiment.xml --extend");
  CHECK(extended.exit_code == 0);
  CHECK_THAT(extended.out, Contains("runs that were added to the experiment: 16\n") &&
                               Contains("small_experiment: 16 runs in "));
  CHECK(here.query("small_experiment.sqlite", old_runs) == before);
  here.check_sound("small_experiment.sqlite");
  // The runs are those of a database that was begun with all of them.
  REQUIRE(here.batch("small_experiment.xml --quiet --database whole.sqlite").exit_code == 0);
  const std::string by_content =
      "SELECT label, seed, state_hash FROM runs JOIN cells ON cells.id = cell_id ORDER BY 1, 2";
  CHECK(here.query("small_experiment.sqlite", by_content) ==
        here.query("whole.sqlite", by_content));
  // Reports are in the order of the experiment, replays find the old and the new runs.
  const auto report = here.elsie("report small_experiment.sqlite");
  CHECK(report.exit_code == 0);
  CHECK_THAT(report.out, Contains("40 runs: 4 cells, 10 seeds"));
  CHECK(report.out.find("\n0.2 ") < report.out.find("\n0.4 "));
  for (const std::string run : {"1", "24", "25", "40"}) {
    CAPTURE(run);
    CHECK_THAT(here.elsie("replay small_experiment.sqlite " + run + " --quiet").out,
               Catch::StartsWith("the same: "));
  }
  CHECK(here.batch("small_experiment.xml --resume --quiet").exit_code == 0);
}

TEST_CASE("A batch that is killed while it extends its database loses nothing") {
  const Laboratory here;
  REQUIRE(here.batch("small_experiment.xml --quiet").exit_code == 0);
  write_grown(here);
  const std::string done = "SELECT count(*) FROM runs WHERE state = 'done' AND id <= 24";
  for (const std::string after_s : {"0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.8"}) {
    here.sh(
        "elsie batch small_experiment.xml --extend --workers 1 & batch=$!\n"
        "sleep " +
        after_s + "; kill -KILL $batch; wait $batch");
    CAPTURE(after_s);
    const std::string runs = here.query("small_experiment.sqlite", "SELECT count(*) FROM runs");
    CHECK((runs == "24\n" || runs == "40\n"));
    CHECK(here.query("small_experiment.sqlite", done) == "24\n");
  }
  CHECK(here.batch("small_experiment.xml --extend --quiet").exit_code == 0);
  CHECK(here.query("small_experiment.sqlite", "SELECT state, count(*) FROM runs GROUP BY 1") ==
        "done|40\n");
  here.check_sound("small_experiment.sqlite");
}

TEST_CASE("What cannot be extended is refused before anything is done") {
  const Laboratory here;
  REQUIRE(here.batch("small_experiment.xml --quiet").exit_code == 0);
  const std::string before = here.table("small_experiment.sqlite");
  const auto refused = [&](const std::string& arguments, const std::string& sentence) {
    CAPTURE(arguments);
    const auto run = here.batch(arguments);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK_THAT(run.err, Contains(sentence));
    CHECK(here.table("small_experiment.sqlite") == before);
  };
  refused("small_experiment.xml --extend --database none.sqlite",
          "--extend: there is no database 'none.sqlite'; begin it without --extend");
  refused("small_experiment.xml --extend --cluster slurm", "--extend does not go with --cluster");
  refused("small_experiment.xml --extend --shard 1/2 --database small_experiment.sqlite",
          "has the shard 1/1 of the experiment, not 1/2");
  const auto rewrite = [&](const std::string& factors, int seeds) {
    here.write("small_experiment.xml",
               Laboratory::experiment("<world file=\"small.xml\"/>", factors, seeds));
  };
  rewrite(speeds("0.05; 0.1; 0.4"), 7);
  refused(
      "small_experiment.xml --extend",
      "the database 'small_experiment.sqlite' cannot be extended to 'small_experiment.xml': "
      "changed since it was begun: the seed 8 (removed); levels, worlds and seeds may be added");
  rewrite(speeds("0.05; 0.2"), 9);
  refused("small_experiment.xml --extend", "the cells '0.1', '0.4' (removed)");
  rewrite(speeds("0.05; 0.1; 0.4", "<exclude where=\"speed=0.4\"/>"), 9);
  refused("small_experiment.xml --extend", "the cell '0.4' (removed)");
  rewrite(speeds("0.05; 0.1; 0.4",
                 "<vary name=\"coverage\" path=\"robot[r1]/@coverage\" values=\"1; 2\"/>"),
          9);
  refused("small_experiment.xml --extend",
          "its factors are world and speed, and now world, speed and coverage");
  rewrite(speeds("0.05; 0.1; 0.4"), 9);
  here.write("small.xml", elsie::test::world_with("wander"));
  refused("small_experiment.xml --extend", "the world '" + here.file("small.xml").string() + "'");
}

TEST_CASE("Formulas are measures of reports, expectations and tables, and may come later") {
  const Laboratory here;
  const std::string world = "<world file=\"small.xml\"/>";
  here.write("small_experiment.xml", Laboratory::experiment(world, speeds("0.1; 0.4"), 3));
  REQUIRE(here.batch("small_experiment.xml --quiet").exit_code == 0);
  here.write("small_experiment.xml",
             Laboratory::experiment(
                 world, speeds("0.1; 0.4"), 3,
                 "<measures><measure name=\"share\" formula=\"path_length_m / (speed * time_s)\" "
                 "unit=\"\" meaning=\"share of the way at full speed\"/>"
                 "<measure name=\"nothing\" formula=\"1 / (collected + 0)\"/></measures>"
                 "<expectations><expect name=\"it is near\" measure=\"share\" at_least=\"0.3\" "
                 "at_most=\"1\"/></expectations>"));
  REQUIRE(here.batch("small_experiment.xml --resume --quiet").exit_code == 0);
  const auto report = here.elsie("report small_experiment.sqlite --json --csv runs.csv");
  CHECK(report.exit_code == 0);
  CHECK(report.err ==
        "elsie: the measure 'nothing' has no value in 6 runs, where its formula divides by 0 or "
        "gives no finite number\n");
  CHECK_THAT(report.out, Contains("share of the way at full speed: path_length_m / (speed * "
                                  "time_s)") &&
                             Contains("it is near"));
  const std::string table = here.read("runs.csv");
  CHECK_THAT(table.substr(0, table.find('\n')), Contains(",share,nothing"));
  const double way_m = std::stod(
      here.query("small_experiment.sqlite",
                 "SELECT value FROM run_measures WHERE run_id = 1 AND measure = 'path_length_m'"));
  const std::string row = table.substr(table.find("\n1,") + 1);
  const std::string share = row.substr(0, row.find('\n'));
  CHECK(std::stod(share.substr(share.rfind(',', share.size() - 2) + 1)) == Approx(way_m / 0.2));
}

TEST_CASE("Chosen runs are recorded, each named by its cell and seed, with the same result") {
  const Laboratory here;
  REQUIRE(here.batch("small_experiment.xml --quiet").exit_code == 0);
  const auto run = here.elsie(
      "replay small_experiment.sqlite --where 'speed=0.05|0.4; seed=2|3' --record recordings "
      "--table");
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());
  CHECK_THAT(run.out, Contains("run 2, 0.05, seed 2: the same: state hash " +
                               here.query("small_experiment.sqlite",
                                          "SELECT state_hash FROM runs WHERE id = 2")) &&
                          Catch::EndsWith("4 of 4 runs are the same; recordings: recordings\n"));
  for (const std::string name : {"0.05_seed-2", "0.05_seed-3", "0.4_seed-2", "0.4_seed-3"}) {
    CAPTURE(name);
    CHECK_THAT(here.elsie("replay recordings/" + name + ".mcap").out,
               Contains("seed " + name.substr(name.size() - 1)) && Contains("complete"));
    CHECK_THAT(here.read("recordings/" + name + ".csv"), Catch::StartsWith("time_s,robot,"));
  }
  CHECK(std::distance(fs::directory_iterator(here.file("recordings")), {}) == 8);
  // A run with another result is told, and so is one that ends its process.
  here.query("small_experiment.sqlite", "UPDATE runs SET state_hash = 'beef' WHERE id = 2");
  const auto other = here.elsie("replay small_experiment.sqlite --where 'seed=2' --quiet");
  CHECK(other.exit_code == 1);
  CHECK(other.out == "2 of 3 runs are the same\n");
  here.write_faulty({"segfaulting", "thrifty"}, "");
  REQUIRE(here.batch("faulty.xml --quiet").exit_code == 3);
  const auto crashed = here.elsie("replay faulty.sqlite --where 'state=*' --record crashes");
  CHECK(crashed.exit_code == 0);
  CHECK_THAT(crashed.out, Contains("segfaulting, seed 1: the same: plugin 'segfaulting'") &&
                              Contains("2 of 2 runs are the same"));
  CHECK(fs::exists(here.file("crashes/segfaulting_seed-1.mcap")));
}

TEST_CASE("A choice of runs that means nothing is refused") {
  const Laboratory here;
  REQUIRE(here.batch("small_experiment.xml --quiet").exit_code == 0);
  const auto refused = [&](const std::string& arguments, const std::string& sentence) {
    CAPTURE(arguments);
    const auto run = here.elsie("replay small_experiment.sqlite " + arguments);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK_THAT(run.err, Contains(sentence));
  };
  refused("--where 'sped=0.1'", "--where: there is no factor 'sped'; did you mean 'speed'?");
  refused("--where 'speed=9'", "--where: 'speed' has no level '9'");
  refused("--where 'outcome=success'", "'outcome' has no level 'success'; it has: time_limit");
  refused("--where ''", "expected FACTOR=LEVEL");
  refused("--where 'speed=0.1' 3", "--where chooses runs, and a number names one");
  refused("--where 'speed=0.1' --record small.xml", "'small.xml' cannot be made");
  refused("--where 'speed=0.1' --record no/where", "'no/where' cannot be made");
  refused("--where 'speed=0.1' --record a --record b", "expected one folder");
  refused("--where 'speed=0.1' --table", "expected --record FOLDER, too");
  refused("--where 'speed=0.1' --picture a.png", "--picture is for one run");
  refused("3 --table", "--table is for many runs of a database; it needs --where");
  refused("3 --workers 2", "--workers is for many runs of a database; it needs --where");
  CHECK_FALSE(fs::exists(here.file("a")));
}

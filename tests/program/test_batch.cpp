// elsie batch: many runs, their database, and the report.
#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "laboratory.h"

using Catch::Contains;
using elsie::test::Laboratory;
namespace fs = std::filesystem;

TEST_CASE("A batch does every run, and the numbers do not depend on the number of workers") {
  const Laboratory here;
  const auto one = here.batch("small_experiment.xml --workers 1 --database one.sqlite");
  CAPTURE(one.err);
  CHECK(one.exit_code == 0);
  CHECK_THAT(one.out, Contains("24 runs in ") && Contains("results: one.sqlite"));
  CHECK_THAT(one.out, Contains("0.05") && Contains("failed"));
  const auto four = here.batch("small_experiment.xml --workers 4 --database four.sqlite --json");
  CHECK(four.exit_code == 0);
  CHECK(four.err.empty());
  const auto summary = nlohmann::json::parse(four.out);
  CHECK(summary["runs"] == 24);
  CHECK(summary["done"] == 24);
  CHECK(summary["failed"] == 0);
  CHECK(summary["to_do"] == 0);
  CHECK(summary["interrupted"] == false);
  CHECK(summary["seeds"] == 8);
  CHECK(summary["seeds_complete"] == 8);
  CHECK(summary["database"] == "four.sqlite");
  CHECK(summary["cells"].size() == 3);
  CHECK(summary["cells"][0]["cell"] == "0.05");
  CHECK(summary["failures"].empty());
  CHECK(here.query("one.sqlite", "SELECT state, count(*) FROM runs GROUP BY state") == "done|24\n");
  CHECK(here.query("one.sqlite", "SELECT count(*) FROM trajectories") == "24\n");
  // Speed and seed matter; after two seconds, robots with some seeds have not turned yet.
  CHECK(std::stoi(here.query("one.sqlite", "SELECT count(DISTINCT state_hash) FROM runs")) > 8);
  CHECK(here.table("one.sqlite") == here.table("four.sqlite"));
  here.check_sound("one.sqlite");
}

TEST_CASE("The default database is named after the experiment, and is not overwritten") {
  const Laboratory here;
  const auto first = here.batch("small_experiment.xml --quiet");
  CHECK(first.exit_code == 0);
  CHECK((first.out + first.err).empty());
  const std::string before = here.table("small_experiment.sqlite");
  const auto again = here.batch("small_experiment.xml");
  CHECK(again.exit_code == 2);
  CHECK(again.out.empty());
  CHECK_THAT(again.err, Contains("'small_experiment.sqlite' already; continue it with --resume"));
  const auto resumed = here.batch("small_experiment.xml --resume");
  CHECK(resumed.exit_code == 0);
  CHECK_THAT(resumed.out, Contains("all 24 runs are done already"));
  CHECK(here.table("small_experiment.sqlite") == before);
}

TEST_CASE("On a terminal a bar shows a batch's progress and remaining time, on one line") {
  const Laboratory here;
  // The lines drawn, each over the one before.
  const auto drawn = [&](int columns) {
    const auto run = here.sh("script -qec 'stty cols " + std::to_string(columns) +
                             "; elsie batch small_experiment.xml --workers 1 --database " +
                             std::to_string(columns) + ".sqlite' /dev/null");
    CHECK(run.exit_code == 0);
    std::vector<std::string> lines;
    std::istringstream parts(run.out.substr(0, run.out.find("Small")));
    for (std::string line; std::getline(parts, line, '\r');) {
      if (const std::size_t end = line.find("\033[K"); end != std::string::npos) {
        lines.push_back(line.substr(0, end));
      }
    }
    return lines;
  };
  const auto wide = drawn(120);
  REQUIRE(wide.size() >= 24);
  CHECK(wide.back().empty());  // cleared
  CHECK_THAT(wide[wide.size() - 2], Contains("100 %  24 of 24 runs"));
  CHECK(std::any_of(wide.begin(), wide.end(), [](const std::string& line) {
    return line.find(" of 24 runs, ") != std::string::npos && line.ends_with(" s left");
  }));
  const auto narrow = drawn(50);
  CHECK(std::all_of(narrow.begin(), narrow.end(),
                    [](const std::string& line) { return line.size() < 50; }));
  CHECK(std::any_of(narrow.begin(), narrow.end(),
                    [](const std::string& line) { return line.ends_with("..."); }));
}

TEST_CASE("Nothing is begun, and no database left behind, when the input is wrong") {
  const Laboratory here;
  here.write("wrong.xml",
             "<experiment format=\"1\"><worlds><world file=\"none.xml\"/></worlds>"
             "<seeds from=\"1\" to=\"2\"/></experiment>");
  const auto refused = [&](const std::string& arguments, const std::string& sentence) {
    CAPTURE(arguments);
    const auto run = here.elsie(arguments);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK_THAT(run.err, Contains(sentence));
    for (const auto& entry : fs::directory_iterator(here.file(""))) {
      CHECK(entry.path().string().find("sqlite") == std::string::npos);
    }
  };
  refused("batch wrong.xml", "none.xml");
  refused("batch nowhere.xml", "nowhere.xml");
  refused("batch small.xml", "small.xml");
  refused("batch ''", "EXPERIMENT: the name of a file is missing");
  refused("batch small_experiment.xml --database no/r.sqlite", "there is no folder 'no'");
  refused("batch small_experiment.xml --database /proc/r.sqlite",
          "no file can be created in the folder '/proc'");
  refused("batch small_experiment.xml --workers 0", "--workers");
  refused("batch small_experiment.xml --database ''", "ends in .sqlite");
  refused("batch small_experiment.xml --database small.xml", "ends in .sqlite");
  refused("batch small_experiment.xml --progress small.xml", "ends in .json");
  refused("batch small_experiment.xml --progress no/p.json", "there is no folder 'no'");
  here.write("other.json", "[1, 2]");
  refused("batch small_experiment.xml --progress other.json", "is not a progress file");
  CHECK(here.read("other.json") == "[1, 2]");
  refused("batch small_experiment.xml --again", "--again needs --resume");
  refused("merge out.sqlite none.db", "there is no database 'none.db'");
  refused("replay none.db 1", "there is no database 'none.db'");
  refused("replay none.db", "'none.db' cannot be read");
  REQUIRE(here.batch("small_experiment.xml --quiet --database runs.db").exit_code == 0);
  fs::rename(here.file("runs.db"), here.file("runs.mcap"));  // by any name
  refused("replay runs.mcap", "'runs.mcap' is a database of many runs; expected the number of one");
  refused("replay runs.mcap 1 --picture run.png --at 1", "--at: only a recording can be drawn");
  refused("replay runs.mcap 1 --record run.csv --record-images", "--record-images: a table");
  refused("batch-worker x", "there is no subcommand 'batch-worker'");
}

TEST_CASE("A batch of one run reports one run") {
  const Laboratory here;
  here.write("one.xml", Laboratory::experiment("<world file=\"small.xml\"/>", "", 1));
  const auto run = here.elsie("batch one.xml");
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.out, Contains("one: 1 run in "));
  CHECK_THAT(here.elsie("batch one.xml --resume").out, Contains("the only run is done already"));
  CHECK(here.elsie("merge all.sqlite one.sqlite").out == "all.sqlite: 1 of 1 run is done\n");
  fs::copy(here.file("one.sqlite"), here.file("two.sqlite"));
  CHECK_THAT(here.elsie("merge again.sqlite one.sqlite two.sqlite").out,
             Contains("\n1 run was in several databases, and counts once\n"));
}

TEST_CASE("The same seed that gives another run is reported") {
  const Laboratory here;
  here.write("twice.xml", Laboratory::experiment("<world file=\"small.xml\"/>", "", 2, "", 2));
  REQUIRE(here.elsie("batch twice.xml --quiet").exit_code == 0);
  here.query("twice.sqlite", "UPDATE runs SET state_hash = 'beef' WHERE id = 4");
  const auto run = here.elsie("batch twice.xml --resume");
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.out, Contains("the same seed gave different runs: small, seed 2, runs 3 4"));
}

TEST_CASE("No output takes the place of a file of another kind") {
  const Laboratory here;
  REQUIRE(here.batch("small_experiment.xml --quiet").exit_code == 0);
  const auto kept = [&](const std::string& arguments, const std::string& file) {
    CAPTURE(arguments);
    const std::string before = here.read(file);
    const auto run = here.elsie(arguments);
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.err, Contains("'" + file + "' already exists and is not a "));
    CHECK(here.read(file) == before);
  };
  fs::copy(here.file("small_experiment.sqlite"), here.file("r.mcap"));
  fs::copy(here.file("small_experiment.sqlite"), here.file("r.png"));
  fs::copy(here.file("small.xml"), here.file("small.csv"));
  fs::copy(here.file("small.xml"), here.file("small.svg"));
  kept("replay r.mcap 3 --record r.mcap", "r.mcap");
  kept("replay r.png 3 --picture r.png", "r.png");
  kept("run small.csv --record small.csv", "small.csv");
  kept("run small.svg --picture small.svg", "small.svg");
  here.write("own.csv", "time_s,robot,x_m,y_m,my_note\n1,a,2,3,keep\n");
  here.write("other.mcap", "\x89MCAP0\r\nrecorded by somebody else");
  kept("run small.xml --record own.csv", "own.csv");
  kept("run small.xml --record other.mcap", "other.mcap");
  here.write("data.csv", "a,b\n1,2\n");
  kept("run small.xml --record data.csv", "data.csv");
  kept("report small_experiment.sqlite --csv data.csv", "data.csv");
  REQUIRE(here.elsie("run small.xml --quiet --record run.csv").exit_code <= 1);
  REQUIRE(here.elsie("report small_experiment.sqlite --quiet --csv report.csv").exit_code == 0);
  kept("report small_experiment.sqlite --csv run.csv", "run.csv");
  kept("run small.xml --record report.csv", "report.csv");
  here.write("empty.csv", "");
  for (const std::string recording : {"run.csv", "empty.csv"}) {
    CHECK(here.elsie("run small.xml --quiet --record " + recording).exit_code <= 1);
    CHECK_THAT(here.read(recording), Catch::StartsWith("time_s,robot,"));
  }
  CHECK(here.elsie("report small_experiment.sqlite --quiet --csv report.csv").exit_code == 0);
  kept("report small_experiment.sqlite --junit small_experiment.xml", "small_experiment.xml");
  CHECK(here.elsie("report small_experiment.sqlite --junit out.xml --quiet").exit_code == 0);
  CHECK(here.elsie("report small_experiment.sqlite --junit out.xml --quiet").exit_code == 0);
}

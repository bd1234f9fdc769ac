#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "places.h"
#include "program.h"

using namespace elsie::test;

TEST_CASE("replay tells what is in a recording") {
  const Workplace here;
  const auto run =
      here.elsie("run worlds/open_arena.xml --duration 5 --seed 9 --record run.mcap --json");
  const std::string hash = nlohmann::json::parse(run.out).at("state_hash");
  const auto replay = here.elsie("replay run.mcap");
  CHECK(replay.exit_code == 0);
  CHECK(replay.err.empty());
  CHECK_THAT(
      replay.out,
      Catch::StartsWith("world 'open arena' (worlds/open_arena.xml), seed 9, recorded by elsie ") &&
          Catch::Contains("\ntime_limit after 5.0 s: ") &&
          Catch::Contains("state hash " + hash + " after 500 steps\n") &&
          Catch::Contains("a sample every 0.1 s\n") && Catch::Contains("\ncomplete\n"));
  CHECK_THAT(replay.out, Catch::Matches("[^]*/robots/r1/state +elsie.State +51\n[^]*") &&
                             Catch::Matches("[^]*/robots/r1/command +elsie.Command +50\n[^]*") &&
                             Catch::Matches("[^]*/robots/r1/trace +elsie.Trace +[0-9]+\n[^]*"));
}

TEST_CASE(
    "replay draws the picture that the run drew, without plugins and without the world file") {
  const Workplace here;
  here.elsie("run worlds/four_resources.xml --duration 30 --record run.mcap --picture run.png");
  const auto replay = here.sh(
      "mkdir -p alone/bin alone/lib/elsie && cp run.mcap alone && cp \"$(command -v elsie)\" "
      "alone/bin"
      " && cp '" +
      build_path("lib/elsie") + "'/elsie-* alone/lib/elsie && cd alone && LD_LIBRARY_PATH='" +
      build_path("lib") + "' bin/elsie replay run.mcap --picture again.png");
  CHECK(replay.err.empty());
  REQUIRE(replay.exit_code == 0);
  CHECK(here.read("run.png").size() > 5000);
  CHECK(here.read("run.png") == here.read("alone/again.png"));
}

TEST_CASE("replay draws the graph that the run drew, or as it was at another time") {
  const Workplace here;
  here.elsie("run worlds/fetch.xml --duration 20 --record run.mcap --graph run.svg --quiet");
  CHECK(here.elsie("replay run.mcap --graph again.svg").exit_code == 0);
  CHECK(here.read("run.svg").size() > 1000);
  CHECK(here.read("again.svg") == here.read("run.svg"));
  CHECK(here.elsie("replay run.mcap --graph r1=early.svg --at 1").exit_code == 0);
  CHECK_THAT(here.read("early.svg"), Catch::Contains("<title>to the gate: running</title>") &&
                                         Catch::Contains("r1: at 1 s"));
  const auto refused = [&](const std::string& options, const std::string& sentence) {
    const auto run = here.elsie("replay " + options);
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.err, Catch::Contains(sentence));
  };
  refused("run.mcap --graph r2=no.svg", "--graph: the recording has no graph of the robot 'r2'");
  refused("run.mcap --graph no.gif", "--graph: a picture's name must end in .png or .svg");
  refused("run.mcap --graph no.svg --at 21", "--at: the recording ends at 20 s");
  here.elsie("run worlds/open_arena.xml --duration 1 --record plain.mcap --quiet");
  refused("plain.mcap --graph no.svg", "--graph: the recording has no graph of a robot");
}

TEST_CASE("replay draws what was there at any time") {
  const Workplace here;
  here.elsie("run worlds/four_resources.xml --duration 30 --record run.mcap");
  CHECK(here.elsie("replay run.mcap --picture a.svg --at 10 --width 500").exit_code == 0);
  CHECK_THAT(here.read("a.svg"), Catch::StartsWith("<?xml"));
  CHECK(here.elsie("replay run.mcap --picture b.svg --at 20 --width 500").exit_code == 0);
  CHECK(here.read("a.svg").size() < here.read("b.svg").size());  // a longer way
  const auto late = here.elsie("replay run.mcap --picture c.svg --at 31");
  CHECK(late.exit_code == 2);
  CHECK(late.err == "elsie: --at: the recording ends at 30 s\n");
}

TEST_CASE("A recording is kept when a plugin fails, and says so") {
  const Workplace here;
  here.write("world.xml", R"(<world format="1"><robots><robot id="r1"><behaviors>
      <throwing/></behaviors><coordinator><arbiter_suppression/></coordinator>
      </robot></robots></world>)");
  const auto run = here.elsie("run world.xml --record run.mcap --plugin-path '" +
                              build_path("tests/program/plugins") + "'");
  CHECK(run.exit_code == 3);
  const auto replay = here.elsie("replay run.mcap");
  CHECK(replay.exit_code == 0);
  CHECK_THAT(replay.out,
             Catch::Contains("\nstopped after 0.5 s: plugin 'throwing' of robot 'r1' failed") &&
                 Catch::Contains("complete"));
}

TEST_CASE("Files that cannot be replayed are refused in a sentence") {
  const Workplace here;
  const auto refusal = [&](const std::string& arguments) {
    const auto run = here.elsie(arguments);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    return run.err;
  };
  CHECK_THAT(refusal("replay nowhere.mcap"),
             Catch::Contains("'nowhere.mcap' cannot be read: No such file"));
  here.elsie("run worlds/open_arena.xml --duration 1 --record run.csv");
  CHECK_THAT(refusal("replay run.csv"),
             Catch::Contains("'run.csv' is neither a recording, as `elsie run --record FILE.mcap` "
                             "writes it, nor a database that `elsie batch` has written"));
  here.elsie("run worlds/open_arena.xml --duration 3 --record run.mcap");
  CHECK_THAT(refusal("replay run.mcap --at 1"),
             Catch::Contains("--at: there is nothing to draw; expected --picture or --graph, too"));
  CHECK_THAT(refusal("replay run.mcap 1"),
             Catch::Contains("RUN: 'run.mcap' is a recording of one run, in which nothing is run "
                             "again"));
  CHECK_THAT(refusal("replay run.mcap --record again.mcap"), Catch::Contains("--record: "));
  CHECK_THAT(refusal("replay run.mcap --picture run.gif"),
             Catch::Contains("must end in .png or .svg"));
  here.write("empty.mcap", "");
  CHECK_THAT(refusal("replay empty.mcap"),
             Catch::Contains("'empty.mcap' is empty; expected a recording, as "));
  // Not even its owner can read the start of it.
  CHECK(refusal("replay /proc/self/mem") ==
        "elsie: '/proc/self/mem' cannot be read: Input/output error\n");
  std::string bytes = here.read("run.mcap");
  // Of the first chunk there is no more than its beginning.
  here.write("begun.mcap", bytes.substr(0, bytes.find("zstd") + 100));
  CHECK(here.elsie("replay begun.mcap").exit_code == 0);
  CHECK(refusal("replay begun.mcap --picture begun.png") ==
        "elsie: --picture: 'begun.mcap' breaks off before its first second was written, with the "
        "world and the robots' places: there is nothing to draw\n");
  CHECK(!std::filesystem::exists(here.file("begun.png")));
  bytes[bytes.find("zstd") + 60] ^= 1;
  here.write("wrong.mcap", bytes);
  CHECK_THAT(refusal("replay wrong.mcap"),
             Catch::Contains("'wrong.mcap' is damaged: the chunk at byte "));
}

TEST_CASE("Options of recordings that do not fit are refused before the run") {
  const Workplace here;
  const auto refusal = [&](const std::string& arguments) {
    const auto run = here.elsie("run worlds/open_arena.xml " + arguments);
    CHECK(run.exit_code == 2);
    return run.err;
  };
  CHECK_THAT(refusal("--record run.txt"),
             Catch::Contains("must end in .csv or .mcap, but 'run.txt'"));
  CHECK_THAT(refusal("--record run.csv --record-images"),
             Catch::Contains("--record-images: a table has no place for pictures"));
  CHECK_THAT(refusal("--record run.mcap --record-images"),
             Catch::Contains("--record-images: no robot of this world has a sensor with a camera"));
  CHECK_THAT(refusal("--record run.mcap --record run.mcap"),
             Catch::Contains("--record: 'run.mcap' is given twice"));
  CHECK(!std::filesystem::exists(here.file("run.mcap")));
  CHECK_THAT(refusal("--record run.csv --record-robots r9"),
             Catch::Contains("--record-robots: there is no robot 'r9' in this world"));
  CHECK_THAT(refusal("--record-images"), Catch::Contains("--record-images requires --record"));
  CHECK(here.elsie("run worlds/open_arena.xml --record /nowhere/run.mcap").exit_code == 2);
}

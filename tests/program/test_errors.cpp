#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "places.h"
#include "program.h"

using elsie::test::Workplace;

TEST_CASE("A world with goals and without robots is checked with a warning") {
  Workplace here;
  here.write("empty.xml",
             "<world format=\"1\"><goals>\n<travel distance=\"1\"/></goals><limits time=\"1\"/>"
             "</world>\n");
  const auto check = here.elsie("check empty.xml");
  CHECK(check.exit_code == 0);
  CHECK_THAT(check.err, Catch::Contains("empty.xml:2: warning: the world has no robot"));
  here.write("endure.xml", "<world format=\"1\"><goals><endure time=\"1\"/></goals></world>\n");
  CHECK(here.elsie("check endure.xml").err.empty());
  CHECK(here.elsie("check worlds/maze.xml").err.empty());
}

TEST_CASE("Bad input ends with exit code 2, a sentence, and nothing on standard output") {
  Workplace here;
  here.write("broken.xml", "<world format=\"1\">\n  <arena length=\"1,5\"/>\n</world>\n");
  here.write("broken.fcl", "FUNCTION_BLOCK x\n  VAR_INPUT\n");
  const auto expect = [&](const std::string& arguments, const std::string& sentence) {
    CAPTURE(arguments);
    const auto run = here.elsie(arguments);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK_THAT(run.err, Catch::Contains(sentence));
  };
  expect("run nowhere.xml --json", "nowhere.xml");
  std::filesystem::create_symlink("loop", here.file("loop"));
  expect("plugins --plugin-path loop", "elsie: --plugin-path: 'loop' is not a directory\n");
  here.write("no_plugin.cpp", "int main() {}\n");
  expect("plugins --plugin no_plugin.cpp", "'no_plugin.cpp' is a shared library without a plugin");
  expect("plugins --plugin loop.so", "elsie: --plugin: there is no file 'loop.so'\n");
  expect("run broken.xml", "broken.xml:2:");
  expect("check broken.xml", "1,5");
  expect("picture broken.xml", "broken.xml:2:");
  expect("run worlds/maze.xml --set 'robot[r9]/@x=1'", "r9");
  expect("run worlds/maze.xml --set 'robot[r1]/@max_speed=fast'", "fast");
  expect("run worlds/maze.xml --picture maze.gif", "must end in .png or .svg");
  expect("run worlds/maze.xml --picture nowhere/maze.png", "there is no folder 'nowhere'");
  expect("run worlds/maze.xml --record nowhere/maze.csv", "there is no folder 'nowhere'");
  expect("run worlds/maze.xml --record worlds", "must end in .csv");
  expect("run worlds/maze.xml --record worlds/maze.xml", "must end in .csv");
  expect("run worlds/maze.xml --record .mcap",
         "--record: '.mcap' lacks a name before its suffix; expected one such as run.mcap");
  expect("run worlds/maze.xml --picture worlds/.png", "'worlds/.png' lacks a name before");
  expect("check ''", "'': the name of a file is missing");
  expect("run worlds/maze.xml --record ''", "must end in .csv");
  expect("run worlds/maze.xml --record-rate 5", "--record");
  expect("describe world --json", "--json is for plugins");
  expect("run worlds/maze.xml --set physics/@step=1e-300", "1e-300");
  expect("run worlds/maze.xml --plugin-path nowhere", "'nowhere' is not a directory");
  expect("chek worlds/maze.xml", "there is no subcommand 'chek'; did you mean 'check'?");
  expect("describe wandr", "did you mean 'wander'?");
  expect("fuzzy broken.fcl", "broken.fcl:");
  expect("fuzzy nowhere.fcl", "nowhere.fcl");
  expect("fuzzy fuzzy_models/avoid_obstacle_left.fcl --input range=0.5",
         "needs a value for 'azimuth'");
  expect("fuzzy fuzzy_models/avoid_obstacle_left.fcl --input range=nan --input azimuth=0",
         "must be a finite number");
  expect("fuzzy fuzzy_models/avoid_obstacle_left.fcl --input rnge=1", "it has: range, azimuth");
}

TEST_CASE("A recording that cannot be written to its end is exit code 4") {
  Workplace here;
  const auto run = here.elsie("run worlds/open_arena.xml --duration 5 --record /dev/full");
  CHECK(run.exit_code == 4);
  CHECK_THAT(run.err, Catch::Contains("recording '/dev/full' could not be written"));
}

TEST_CASE("A result that cannot be written is no success") {
  Workplace here;
  for (const char* command : {"run worlds/pushing.xml --json", "schema", "plugins", "--help"}) {
    CAPTURE(command);
    const auto run = here.sh("elsie " + std::string(command) + " > /dev/full");
    CHECK(run.exit_code == 4);
    CHECK_THAT(run.err, Catch::Contains("standard output could not be written to its end"));
  }
}

TEST_CASE("Junk among the plugins never stops a run, and plugins --check reports it") {
  Workplace here;
  std::filesystem::create_directory(here.file("junk"));
  here.write("junk/noise.so", "this is no library");
  here.write("junk/empty.so", "");
  const auto run = here.elsie("run worlds/open_arena.xml --duration 1 --plugin-path junk --quiet");
  CHECK(run.exit_code == 1);
  const auto check = here.elsie("plugins --check --plugin-path junk");
  CHECK(check.exit_code == 0);
  CHECK_THAT(check.out, Catch::Contains("noise.so: ") && Catch::Contains("empty.so: "));
  CHECK_THAT(check.out, Catch::Contains("wander.so: loaded: behavior wander 1.0"));
}

TEST_CASE("A run's result is printed even when its picture cannot be written") {
  if (!std::filesystem::exists("/proc/self")) {
    return;
  }
  Workplace here;
  const auto run = here.elsie(
      "run worlds/layers.xml --duration 1 --record run.mcap --json --picture /proc/run.png");
  CHECK(run.exit_code == 4);
  CHECK_THAT(run.out, Catch::Contains("\"outcome\""));
  CHECK_THAT(run.err, Catch::Contains("Cannot write the picture '/proc/run.png'"));
  const auto explained = here.elsie("explain run.mcap --picture /proc/run.png");
  CHECK(explained.exit_code == 4);
  CHECK_THAT(explained.out, Catch::Contains("who decided"));
  CHECK_THAT(explained.err, Catch::Contains("Cannot write the picture '/proc/run.png'"));
}

TEST_CASE("A wrong command line is reported in sentences") {
  Workplace here;
  const auto refused = [&](const std::string& arguments) {
    const auto run = here.elsie(arguments);
    CAPTURE(arguments);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    return run.err.substr(0, run.err.find('\n'));
  };
  CHECK(refused("") == "elsie: a subcommand is missing");
  CHECK(refused("runn worlds/maze.xml") ==
        "elsie: there is no subcommand 'runn'; did you mean 'run'?");
  CHECK(refused("run worlds/maze.xml --sed 3") ==
        "elsie: `elsie run` has no option '--sed'; did you mean '--seed'?");
  CHECK(refused("run") == "elsie: WORLD is missing");
  CHECK(refused("run a.xml b.xml") == "elsie: nothing is expected where 'b.xml' is");
  CHECK(refused("run worlds/maze.xml --seed") == "elsie: --seed takes a value, which is missing");
  CHECK(refused("run worlds/maze.xml --picture a.png --picture b.png") ==
        "elsie: --picture is given 2 times; it may be given once");
  CHECK(refused("picture worlds/maze.xml --width 1e3") ==
        "elsie: --width: '1e3' is not a whole number from 200 to 8000");
  CHECK(refused("picture worlds/maze.xml --width 8001") ==
        "elsie: --width: '8001' is not a whole number from 200 to 8000");
  CHECK(refused("test-plugin wander --memory-limit 49.5") ==
        "elsie: --memory-limit: '49.5' is not a number from 50 to 1000000");
  CHECK(refused("explain a.mcap --from -1") ==
        "elsie: --from: '-1' is not a number of zero or above");
  CHECK(
      refused("describe camera vision") ==
      "elsie: 'camera' is not a kind of plugins; there are sensor, behavior, coordinator, measure, "
      "rule, drive, localisation, actuator");
  CHECK(here.elsie("describe behaviour wander").exit_code == 0);
  for (const char* numbers : {"--seed x", "--seed -1", "--seed 1.5", "--duration nan",
                              "--duration 0", "--duration 1,5", "--record-rate -2"}) {
    CHECK_THAT(refused("run worlds/maze.xml " + std::string(numbers)),
               Catch::Contains(" is not a "));
  }
}

TEST_CASE("No output replaces what a subcommand reads, and two outputs are two files") {
  Workplace here;
  REQUIRE(here.elsie("run worlds/open_arena.xml --duration 0.1 --quiet --picture plan.png "
                     "--record run.mcap")
              .exit_code <= 1);  // the goal may be missed
  here.write("world.xml",
             "<world format=\"1\"><robots><robot id=\"a\" x=\"1\"/></robots><layouts><floor_plan "
             "id=\"p\" file=\"plan.png\" metres_per_pixel=\"0.002\"/></layouts><limits "
             "time=\"0.1\"/></world>\n");
  const std::string plan = here.read("plan.png"), recording = here.read("run.mcap");
  std::filesystem::copy_file(here.file("run.mcap"), here.file("run.png"));
  std::filesystem::create_symlink("plan.png", here.file("link.png"));
  const auto refused = [&](const std::string& arguments, const std::string& sentence) {
    CAPTURE(arguments);
    const auto run = here.elsie(arguments);
    CHECK(run.exit_code == 2);
    CHECK_THAT(run.err, Catch::Contains(sentence));
  };
  const std::string lost = "read here, and its content would be lost";
  refused("run world.xml --picture plan.png", "plan.png' is " + lost);
  refused("run world.xml --picture link.png", lost);
  refused("picture world.xml plan.png", "PICTURE: 'plan.png' is " + lost);
  refused("picture world.xml -o ./plan.png", "--output: './plan.png' is " + lost);
  refused("replay run.png --picture run.png", lost);
  refused("explain run.png --picture run.png", lost);
  refused("fuzzy plan.png --picture plan.png", lost);
  refused("run world.xml --record a.csv --record ./a.csv", "--record: './a.csv' is given twice");
  CHECK(here.read("plan.png") == plan);
  CHECK(here.read("run.png") == recording);
}

TEST_CASE("Of two runs that record one file, the second is refused, and the first is complete") {
  Workplace here;
  const std::string run = "elsie run worlds/open_arena.xml --quiet --duration ";
  const auto both =
      here.sh(run +
              "1e6 --record same.mcap & p=$!\n"
              "until [ -s same.mcap ]; do :; done\n" +
              run + "1 --record same.mcap 2> refusal || echo $?\nkill -TERM $p; wait $p || true");
  CHECK_THAT(both.out, Catch::StartsWith("2\n"));
  CHECK_THAT(here.read("refusal"), Catch::Contains("'same.mcap' is being written by another run"));
  CHECK_THAT(here.elsie("replay same.mcap").out, Catch::Contains("complete\n"));
}

TEST_CASE("A rate of recording that does not fit the steps is said, and one that fits is not") {
  Workplace here;
  const auto warning = [&](const std::string& rate) {
    return here
        .elsie("run worlds/open_arena.xml --duration 0.1 --record r.csv --record-rate " + rate)
        .err;
  };
  CHECK_THAT(warning("40"), Catch::Contains("--record-rate 40: samples are whole steps of 0.01 s "
                                            "apart; recorded are 33.3333 a second"));
  CHECK_THAT(warning("1000"), Catch::Contains("recorded are 100 a second"));
  CHECK(warning("20").empty());
}

TEST_CASE("A run has one longest duration, and a seed one range, wherever they are given") {
  Workplace here;
  CHECK_THAT(here.elsie("run worlds/maze.xml --duration 1e13").err,
             Catch::Contains("'1e13' is not a number above zero and at most 1000000000"));
  CHECK(here.elsie("run worlds/maze.xml --set limits/@time=1e13").exit_code == 2);
  here.write("seeds.xml",
             "<experiment format=\"1\"><worlds><world file=\"worlds/maze.xml\"/></worlds>"
             "<seeds from=\"18446744073709551614\" to=\"18446744073709551615\"/></experiment>");
  CHECK(here.elsie("check seeds.xml").exit_code == 0);
}

// Many runs: batches that fail, are killed and go on; shards; runs done again.
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "laboratory.h"
#include "places.h"
#include "program.h"

using Catch::Contains;
using elsie::test::Laboratory;
using elsie::test::ProgramRun;
using elsie::test::world_with;
namespace fs = std::filesystem;

TEST_CASE("A batch does every run, and the numbers do not depend on the number of workers") {
  const Laboratory here;
  const auto one = here.batch("small_experiment.xml --workers 1 --database one.sqlite");
  CAPTURE(one.err);
  CHECK(one.exit_code == 0);
  CHECK_THAT(one.out, Contains("24 runs in ") && Contains("results: one.sqlite"));
  CHECK_THAT(one.out, Contains("0.05") && Contains("failed"));
  const auto four = here.batch("small_experiment.xml --workers 4 --database four.sqlite --quiet");
  CHECK(four.exit_code == 0);
  CHECK(four.out.empty());
  CHECK(four.err.empty());
  CHECK(here.query("one.sqlite", "SELECT state, count(*) FROM runs GROUP BY state") == "done|24\n");
  CHECK(here.query("one.sqlite", "SELECT count(*) FROM trajectories") == "24\n");
  // Speed and seed matter; after two seconds some seeds have not turned yet.
  CHECK(std::stoi(here.query("one.sqlite", "SELECT count(DISTINCT state_hash) FROM runs")) > 8);
  CHECK(here.table("one.sqlite") == here.table("four.sqlite"));
  here.check_sound("one.sqlite");
}

TEST_CASE("A run of a batch is the run that elsie run makes") {
  const Laboratory here;
  REQUIRE(here.batch("small_experiment.xml --quiet").exit_code == 0);
  const auto alone = here.elsie("run small.xml --seed 5 --set 'robot[r1]/@max_speed=0.4' --json");
  const auto result = nlohmann::json::parse(alone.out);
  CHECK(
      here.query("small_experiment.sqlite",
                 "SELECT state_hash FROM runs JOIN cells ON cells.id = cell_id WHERE seed = 5 AND "
                 "label = '0.4'") == result["state_hash"].get<std::string>() + "\n");
}

TEST_CASE("The default database is named after the experiment, and is not overwritten") {
  const Laboratory here;
  CHECK(here.batch("small_experiment.xml --quiet").exit_code == 0);
  const std::string before = here.table("small_experiment.sqlite");
  const auto again = here.batch("small_experiment.xml");
  CHECK(again.exit_code == 2);
  CHECK(again.out.empty());
  CHECK_THAT(again.err, Contains("'small_experiment.sqlite' already; go on with it by --resume"));
  const auto resumed = here.batch("small_experiment.xml --resume");
  CHECK(resumed.exit_code == 0);
  CHECK_THAT(resumed.out, Contains("all 24 runs are done already"));
  CHECK(here.table("small_experiment.sqlite") == before);
}

TEST_CASE("The summary is to be had as JSON") {
  const Laboratory here;
  const auto run = here.batch("small_experiment.xml --json");
  CHECK(run.err.empty());
  const auto summary = nlohmann::json::parse(run.out);
  CHECK(summary["runs"] == 24);
  CHECK(summary["done"] == 24);
  CHECK(summary["failed"] == 0);
  CHECK(summary["to_do"] == 0);
  CHECK(summary["interrupted"] == false);
  CHECK(summary["database"] == "small_experiment.sqlite");
  CHECK(summary["cells"].size() == 3);
  CHECK(summary["cells"][0]["cell"] == "0.05");
  CHECK(summary["failures"].empty());
}

TEST_CASE(
    "A crash, a hang or a plugin that fails costs one run, and is told with all that is known") {
  const Laboratory here;
  here.write_faulty({"segfaulting", "aborting", "overflowing", "looping", "not_a_number",
                     "throwing", "exiting", "thrifty"},
                    "<limits time=\"2\" wall_time=\"4\"/>");
  const auto run = here.batch("faulty.xml --workers 2");
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.out, Contains("elsie replay faulty.sqlite 1"));
  const auto facts = [&](const std::string& world) {
    return here.query("faulty.sqlite",
                      "SELECT state, outcome, signal, plugin, robot, step FROM runs JOIN cells ON "
                      "cells.id = cell_id WHERE world = '" +
                          world + "'");
  };
  CHECK(facts("segfaulting") == "crash|null|SIGSEGV|segfaulting|r1|50\n");
  CHECK(facts("overflowing") == "crash|null|SIGSEGV|overflowing|r1|50\n");
  CHECK(facts("aborting") == "crash|null|SIGABRT|aborting|r1|50\n");
  CHECK(facts("exiting") == "crash|null|null|exiting|r1|50\n");
  CHECK(facts("looping") == "hang|null|null|looping|r1|50\n");
  CHECK(facts("not_a_number") == "fault|null|null|not_a_number|r1|50\n");
  CHECK(facts("throwing") == "fault|null|null|throwing|r1|50\n");
  CHECK(facts("thrifty") == "done|time_limit|null|null|null|null\n");
  const std::string log =
      here.query("faulty.sqlite",
                 "SELECT log FROM runs JOIN cells ON cells.id = cell_id WHERE world = "
                 "'segfaulting'");
  CHECK_THAT(log, Contains("segmentation fault (SIGSEGV) in step 50") && Contains("the stack"));
  CHECK(
      here.query("faulty.sqlite", "SELECT message FROM runs WHERE plugin = 'looping'") ==
      "the run did not end within 4 s on the clock and was ended, while plugin 'looping' of robot "
      "'r1' was at work in step 50\n");
  CHECK(here.query("faulty.sqlite", "SELECT message FROM runs WHERE plugin = 'segfaulting'") ==
        "plugin 'segfaulting' of robot 'r1' crashed with SIGSEGV in step 50\n");
  // What was recorded until a plugin threw is kept; there are no measures of it.
  CHECK(here.query("faulty.sqlite",
                   "SELECT count(*) FROM trajectories JOIN runs ON runs.id = run_id "
                   "WHERE state = 'fault'") == "2\n");
  CHECK(here.query("faulty.sqlite", "SELECT count(DISTINCT run_id) FROM run_measures") == "1\n");
  here.check_sound("faulty.sqlite");

  SECTION("they are not done again unless that is asked for") {
    const auto resumed = here.batch("faulty.xml --resume");
    CHECK(resumed.exit_code == 3);
    CHECK_THAT(resumed.out, Contains("all 8 runs are done already"));
    const auto again = here.batch("faulty.xml --resume --again");
    CHECK(again.exit_code == 3);
    CHECK_THAT(again.out, Contains("are done again: 7\n") && Contains("7 runs in "));
    here.check_sound("faulty.sqlite");
  }
  SECTION("one that failed in order fails again in the same way; a crash is shown with its stack") {
    const auto number = [&](const std::string& plugin) {
      const std::string text =
          here.query("faulty.sqlite", "SELECT id FROM runs WHERE plugin = '" + plugin + "'");
      return text.substr(0, text.size() - 1);
    };
    const auto fault = here.elsie("replay faulty.sqlite " + number("throwing"));
    CHECK(fault.exit_code == 0);
    CHECK_THAT(fault.out, Contains("the same: plugin 'throwing' of robot 'r1' failed in step 50"));
    const auto crash = here.elsie("replay faulty.sqlite " + number("segfaulting"));
    CHECK(crash.exit_code == 3);
    CHECK_THAT(crash.out, Contains("before: crash, plugin 'segfaulting' of robot 'r1' crashed"));
    CHECK_THAT(crash.err, Contains("ended the program with a segmentation fault"));
  }
}

TEST_CASE("A worker that is killed from outside costs its run only") {
  const Laboratory here;
  here.write_faulty({"dawdling"}, Laboratory::kTwoDawdledSteps, 3);
  const auto run = here.sh(
      "elsie batch faulty.xml --workers 1 --quiet --plugin-path " + Laboratory::plugins() +
      " & batch=$!\n"
      "while ! worker=$(cat /proc/$batch/task/$batch/children) || [ -z \"$worker\" ]; do sleep "
      "0.02; done\n"
      "kill -9 $worker\n"
      "wait $batch && code=$? || code=$?\n"
      "exit $code");
  CHECK(run.exit_code == 3);
  CHECK(here.query("faulty.sqlite", "SELECT state, signal FROM runs ORDER BY id") ==
        "crash|SIGKILL\ndone|null\ndone|null\n");
  CHECK(here.batch("faulty.xml --resume --again --quiet").exit_code == 0);
}

TEST_CASE("A batch that is killed goes on where it was: no run is lost, none done twice") {
  const Laboratory here;
  here.write("many.xml", Laboratory::experiment("<world file=\"small.xml\"/>", Laboratory::kSpeeds,
                                                16, "<limits time=\"10\"/>"));
  REQUIRE(here.elsie("batch many.xml --quiet --database whole.sqlite").exit_code == 0);
  std::string ended;  // of each run, as soon as it has ended
  int kills = 0;
  for (; kills < 200; ++kills) {
    // Somewhere in what it does; later and later, so that a slow machine comes to its runs, too.
    const int milliseconds = 30 + std::rand() % (100 + 30 * kills);
    const auto run = here.sh(
        "elsie batch many.xml --quiet --database killed.sqlite --resume & batch=$!\n"
        "sleep " +
        std::to_string(milliseconds / 1000.0) +
        "\n"
        "kill -9 $batch 2>/dev/null || true\n"
        "wait $batch && code=$? || code=$?\n"
        "exit $code");
    if (!fs::exists(here.file("killed.sqlite"))) {
      continue;
    }
    if (run.exit_code == 0) {
      break;
    }
    CHECK(run.exit_code == 128 + 9);
    try {
      const std::string now = here.query(
          "killed.sqlite", "SELECT id, ended FROM runs WHERE state <> 'pending' ORDER BY id");
      std::istringstream lines(ended);
      for (std::string line; std::getline(lines, line);) {
        CHECK_THAT(now, Contains(line + "\n"));
      }
      ended = now;
    } catch (const std::runtime_error& error) {
      CHECK_THAT(error.what(), Contains("no such table"));  // killed before it was made
    }
    if (kills > 20) {  // a slow machine: let it come to an end
      CHECK(here.elsie("batch many.xml --quiet --database killed.sqlite --resume").exit_code == 0);
      break;
    }
  }
  CHECK(kills > 1);
  CHECK(here.table("killed.sqlite") == here.table("whole.sqlite"));
  CHECK(here.query("killed.sqlite", "SELECT count(*) FROM runs WHERE state = 'done'") == "48\n");
  here.check_sound("killed.sqlite");
}

TEST_CASE("The workers of a batch that is killed die with it") {
  const Laboratory here;
  here.write_faulty({"looping"}, "", 2);
  const auto run =
      here.sh("elsie batch faulty.xml --workers 2 --quiet --plugin-path " + Laboratory::plugins() +
              " & batch=$!\n"
              "while [ $(wc -w < /proc/$batch/task/$batch/children) -lt 2 ]; do sleep 0.02; done\n"
              "workers=$(cat /proc/$batch/task/$batch/children)\n"
              "kill -9 $batch; wait $batch || true\n"
              "for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do\n"
              "  left=0; for w in $workers; do\n"
              "    if grep -q '^State:.[RSD]' /proc/$w/status 2>/dev/null; then left=1; fi; done\n"
              "  if [ $left = 0 ]; then exit 0; fi; sleep 0.1\n"
              "done; exit 1");
  CHECK(run.exit_code == 0);
}

TEST_CASE("Ctrl-C stops a batch in order: what is done is kept, the rest stays to be done") {
  const Laboratory here;
  here.write_faulty({"thrifty", "dawdling"}, Laboratory::kTwoDawdledSteps, 2);
  for (const std::string signal : {"INT", "TERM"}) {
    const std::string name = signal + ".sqlite";
    const auto run = here.sh("elsie batch faulty.xml --workers 1 --database " + name +
                             " --plugin-path " + Laboratory::plugins() +
                             " & batch=$!\n"
                             "while ! sqlite3 " +
                             name +
                             " 'SELECT count(*) FROM runs WHERE state = \"done\"' 2>/dev/null "
                             "| grep -q 2; do sleep 0.05; done\n"
                             "kill -" +
                             signal +
                             " $batch\n"
                             "wait $batch && code=$? || code=$?\n"
                             "exit $code");
    CHECK(run.exit_code == 4);
    CHECK_THAT(run.out, Contains("results: " + name));
    CHECK_THAT(run.err,
               Contains("interrupted; 2 of 4 runs are still to be done. Go on with\n  elsie "
                        "batch faulty.xml --plugin-path " +
                        Laboratory::plugins() + " --database " + name + " --resume\n"));
    CHECK(here.query(name, "SELECT state FROM runs ORDER BY id") ==
          "done\ndone\npending\npending\n");
    CHECK_FALSE(fs::exists(here.file(name + "-lock")));
  }
  CHECK(here.batch("faulty.xml --database INT.sqlite --resume --quiet").exit_code == 0);
  here.check_sound("INT.sqlite");
}

TEST_CASE("Two batches do not write one database") {
  const Laboratory here;
  here.write_faulty({"dawdling"}, Laboratory::kTwoDawdledSteps, 2);
  const auto run =
      here.sh("elsie batch faulty.xml --workers 1 --quiet --plugin-path " + Laboratory::plugins() +
              " & batch=$!\n"
              "while [ $(wc -w < /proc/$batch/task/$batch/children) = 0 ]; do sleep 0.02; done\n"
              "elsie batch faulty.xml --resume --plugin-path " +
              Laboratory::plugins() +
              " && code=$? || code=$?\n"
              "wait $batch\n"
              "exit $code");
  CHECK(run.exit_code == 2);
  CHECK_THAT(run.err, Contains("is being written by another batch (process "));
  CHECK(here.query("faulty.sqlite", "SELECT count(*) FROM runs WHERE state = 'done'") == "2\n");
}

TEST_CASE("A full disk ends a batch with a sentence; it goes on when there is room") {
  const Laboratory here;
  here.write("many.xml", Laboratory::experiment("<world file=\"small.xml\"/>", Laboratory::kSpeeds,
                                                8, "<trajectories period=\"0.01\"/>"));
  // No file may grow beyond this, as on a disk that is full.
  const auto full = here.sh("ulimit -f 300; elsie batch many.xml --quiet");
  CHECK(full.exit_code == 4);
  CHECK_THAT(full.err, Contains("the database 'many.sqlite' could not be written: ") &&
                           Contains("elsie batch many.xml --database many.sqlite --resume"));
  CHECK(here.query("many.sqlite", "SELECT count(*) FROM runs WHERE state = 'pending'") != "0\n");
  CHECK(here.elsie("batch many.xml --quiet --resume").exit_code == 0);
  REQUIRE(here.elsie("batch many.xml --quiet --database whole.sqlite").exit_code == 0);
  CHECK(here.table("many.sqlite") == here.table("whole.sqlite"));
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
  CHECK(here.table("part.sqlite") == here.table("whole.sqlite"));

  const auto wrong = here.batch("small_experiment.xml --shard 4/3");
  CHECK(wrong.exit_code == 2);
  CHECK_THAT(wrong.err, Contains("--shard: '4/3' is no part of an experiment"));
}

TEST_CASE("A run that is replayed comes to the same, and can be looked at") {
  const Laboratory here;
  REQUIRE(here.batch("small_experiment.xml --quiet").exit_code == 0);
  const auto run = here.elsie(
      "replay small_experiment.sqlite 17 --picture run.png --record run.csv "
      "--explain run.trace");
  CAPTURE(run.err);
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());
  CHECK_THAT(run.out, Contains("the same: state hash ") && Contains("0.4, seed 1"));
  CHECK(here.read("run.png").starts_with("\x89PNG"));
  CHECK(here.read("run.csv").starts_with("time_s,"));
  CHECK(here.elsie("explain run.trace").exit_code == 0);

  // Recorded for viewers, it is the same run.
  const auto recorded = here.elsie("replay small_experiment.sqlite 17 --quiet --record run.mcap");
  CHECK(recorded.exit_code == 0);
  const std::string same = "the same: ";
  REQUIRE_THAT(recorded.out, Catch::StartsWith(same + "state hash "));
  CHECK_THAT(here.elsie("replay small_experiment.sqlite 17 --record i.mcap --record-images").err,
             Contains("--record-images: no robot of this world has a sensor with a camera"));
  CHECK_THAT(here.elsie("replay run.mcap").out,
             Contains(recorded.out.substr(same.size(), recorded.out.find('\n') - same.size())));

  const auto none = here.elsie("replay small_experiment.sqlite 25");
  CHECK(none.exit_code == 2);
  CHECK_THAT(none.err, Contains("has no run 25; its runs have numbers from 1 to 24"));
  CHECK(here.elsie("replay small.xml 1").exit_code == 2);

  here.query("small_experiment.sqlite", "UPDATE runs SET state_hash = 'beef' WHERE id = 3");
  const auto other = here.elsie("replay small_experiment.sqlite 3");
  CHECK(other.exit_code == 1);
  CHECK_THAT(other.out, Contains("not the same: state hash ") && Contains("before beef"));
}

TEST_CASE("A replay takes from the database what has changed on disk, and says so") {
  const Laboratory here;
  fs::remove(here.file("fuzzy_models"));
  fs::copy(elsie::test::source_path("fuzzy_models"), here.file("fuzzy_models"));
  fs::create_directory(here.file("mine"));
  fs::copy(elsie::test::plugin_directory() + "/wander.so", here.file("mine/wander.so"));
  here.write("small.xml", world_with("wander",
                                     "<avoid_obstacle left_model=\"fuzzy_models/"
                                     "avoid_obstacle_left.fcl\"/>"));
  REQUIRE(here.elsie("batch small_experiment.xml --quiet --plugin-path mine").exit_code == 0);
  CHECK(here.elsie("replay small_experiment.sqlite 1").err.empty());

  const std::string model = "fuzzy_models/avoid_obstacle_left.fcl";
  const std::string content = here.read(model);
  here.write(model, "FUNCTION_BLOCK nonsense");
  here.write("small.xml", "<world/>");
  auto run = here.elsie("replay small_experiment.sqlite 1 --quiet");
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.err, Contains(model + "' has changed since; the run takes what was in it"));
  fs::remove_all(here.file("fuzzy_models"));
  run = here.elsie("replay small_experiment.sqlite 1 --quiet");
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.err, Contains(model + "' is not there any more"));

  here.write("mine/wander.so", here.read("mine/wander.so") + "more");
  run = here.elsie("replay small_experiment.sqlite 1 --quiet");
  CHECK(run.exit_code == 0);  // the code is the same
  CHECK_THAT(run.err, Contains("plugin 'behavior wander 1.0' comes from another library") &&
                          Contains("(it has changed since)"));
  fs::remove(here.file("mine/wander.so"));
  run = here.elsie("replay small_experiment.sqlite 1 --quiet");
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.err, !Contains("comes from another library"));  // the shipped one is the same
}

TEST_CASE("A replay notices that the library of any plugin has changed, a measure's too") {
  const Laboratory here;
  const std::vector<std::string> names{"beam_range", "wander", "fusion_vector_summation",
                                       "path_length"};
  fs::create_directory(here.file("mine"));
  for (const std::string& name : names) {
    fs::copy(elsie::test::plugin_directory() + "/" + name + ".so",
             here.file("mine/" + name + ".so"));
  }
  std::string world = world_with("wander");
  world.insert(world.find("<robots>"), "<measures><path_length id=\"way\"/></measures>");
  here.write("small.xml", world);
  REQUIRE(here.batch("small_experiment.xml --quiet --plugin-path mine").exit_code == 0);
  CHECK(here.elsie("replay small_experiment.sqlite 1").err.empty());
  for (const std::string& name : names) {
    const std::string library = "mine/" + name + ".so", content = here.read(library);
    here.write(library, content + "more");
    const auto run = here.elsie("replay small_experiment.sqlite 1 --quiet");
    CHECK(run.exit_code == 0);  // the code is the same
    CHECK_THAT(run.err, Contains(" " + name + " ") && Contains("(it has changed since)"));
    here.write(library, content);
  }
}

TEST_CASE("A batch notices what changes under its feet") {
  const Laboratory here;
  fs::remove(here.file("fuzzy_models"));
  fs::copy(elsie::test::source_path("fuzzy_models"), here.file("fuzzy_models"));
  const std::string model = "fuzzy_models/avoid_obstacle_left.fcl";
  here.write("small.xml", world_with("dawdling", "<avoid_obstacle left_model=\"" + model + "\"/>"));
  here.write("small_experiment.xml", Laboratory::experiment("<world file=\"small.xml\"/>", "", 3,
                                                            Laboratory::kTwoDawdledSteps));
  const std::string content = here.read(model);
  const auto run = here.sh(
      "elsie batch small_experiment.xml --workers 1 --plugin-path " + Laboratory::plugins() +
      " & batch=$!\n"
      "while [ $(wc -w < /proc/$batch/task/$batch/children) = 0 ]; do sleep 0.02; done\n"
      "echo >> " +
      model +
      "\n"
      "wait $batch && code=$? || code=$?\n"
      "exit $code");
  CHECK(run.exit_code == 4);
  CHECK_THAT(run.err, Contains(model + "' has changed since the batch began"));
  CHECK(here.query("small_experiment.sqlite",
                   "SELECT count(*) FROM runs WHERE state = 'pending'") != "0\n");
  auto resumed = here.batch("small_experiment.xml --resume");
  CHECK(resumed.exit_code == 2);
  CHECK_THAT(resumed.err, Contains("these files have changed since: '"));
  here.write(model, content);
  resumed = here.batch("small_experiment.xml --resume --quiet");
  CHECK(resumed.exit_code == 0);
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
  refused("batch small_experiment.xml --database no/r.sqlite", "there is no folder 'no'");
  refused("batch small_experiment.xml --workers 0", "--workers");
  refused("batch small_experiment.xml --database ''", "ends in .sqlite");
  refused("batch small_experiment.xml --database small.xml", "ends in .sqlite");
  refused("batch small_experiment.xml --progress small.xml", "ends in .json");
  refused("batch small_experiment.xml --progress no/p.json", "there is no folder 'no'");
  here.write("other.json", "[1, 2]");
  refused("batch small_experiment.xml --progress other.json", "is no progress of a batch");
  CHECK(here.read("other.json") == "[1, 2]");
  refused("batch small_experiment.xml --again", "it needs --resume");
  refused("merge out.sqlite none.db", "there is no database 'none.db'");
  refused("replay none.db 1", "there is no database 'none.db'");
  refused("replay none.db", "'none.db' cannot be read");
  REQUIRE(here.batch("small_experiment.xml --quiet --database runs.db").exit_code == 0);
  fs::rename(here.file("runs.db"), here.file("runs.mcap"));  // whatever it is called
  refused("replay runs.mcap", "'runs.mcap' is a database of many runs; expected the number of one");
  refused("replay runs.mcap 1 --picture run.png --at 1", "--at: only a recording can be drawn");
  refused("replay runs.mcap 1 --record run.csv --record-images", "--record-images: a table");
  refused("batch-worker x", "there is no subcommand 'batch-worker'");
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
    CHECK_THAT(run.err, Contains("'" + file + "' is there already and is no "));
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
  kept("report small_experiment.sqlite --junit small_experiment.xml", "small_experiment.xml");
  CHECK(here.elsie("report small_experiment.sqlite --junit out.xml --quiet").exit_code == 0);
  CHECK(here.elsie("report small_experiment.sqlite --junit out.xml --quiet").exit_code == 0);
}
